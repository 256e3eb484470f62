#pragma once
#include "bench/tiles/report.h"

namespace solitaire::tiles::bench {

// The figures and the table of Yeh et al., "Synthesis of Tiled Patterns using Factor Graphs" (2012), by their
// numbers there.

void texture_synthesis(Report& report);  // 7
void facades_in_an_l(Report& report);    // 8 and 9
void burn_in(Report& report);            // 10
void single_sites(Report& report);       // 11
void sizes_of_blocks(Report& report);    // 12
void growing_cities(Report& report);     // 13, left
void growing_facades(Report& report);    // 13, right
void growing_epsilon(Report& report);    // table I

// What the paper does not have.

void exactness(Report& report);      // draws against enumeration
void never_broken(Report& report);   // random problems, looked at after each window
void marginals(Report& report);      // frequencies of fresh maps against the exemplar's
void large_starts(Report& report);   // time, memory and growth, from 85x85 to 1000x1000
void peers(Report& report);          // success, time and likeness beside WaveFunctionCollapse, by size
void speed(Report& report);          // of windows
void filling_again(Report& report);  // a part of a large map

}  // namespace solitaire::tiles::bench
