#pragma once

/// Marks what the shared library shows to other programs.
#define SOLITAIRE_API __attribute__((visibility("default")))
