// SPDX-License-Identifier: GPL-3.0-or-later
//
// results.cpp - a deck in, named numbers out, in C++98.
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <fourlink.h>

int main()
{
    const char *const names[] = {"theta4", "Ts", "min(Ts)", "mu_min"};
    std::string text((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>());
    fourlink_source source = fourlink_source();
    fourlink_mistake mistake;
    fourlink_results *results;
    fourlink_value v;

    source.text = text.data();
    source.length = text.size();
    int status = fourlink_results_open(&source, 1, &results, &mistake, 0);
    if (status == FOURLINK_BAD_DECK)
        std::cout << mistake.line << ": " << mistake.message << '\n';
    for (int i = 0; status == FOURLINK_OK && i < 4; i++)
        if (fourlink_results_value(results, names[i], FOURLINK_OPEN, 40, &v) == FOURLINK_OK)
            std::cout << v.name << " = " << std::fixed << std::setprecision(9) << v.value << ' '
                      << v.unit << '\n';
    if (status == FOURLINK_OK)
        fourlink_results_free(results);
}
