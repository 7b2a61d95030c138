set(LINKS oblong_costs)
