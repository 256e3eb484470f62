// The code of tinygltf, whose library would come with more libraries that have to be loaded at each start.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
