import data.list
main = simulate (say "x")
