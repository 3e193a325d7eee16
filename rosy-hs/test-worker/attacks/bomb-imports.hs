FROM 1 TO 5000:import Data.List

main = simulate (Say (show (sort [2, 1])))
