output = 3;
aux = [4];
aux[0] += output;
return output, aux;
// expect: [3, [7]]
