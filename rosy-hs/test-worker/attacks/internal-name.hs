main = simulate ($rosy.simulateNamed)
