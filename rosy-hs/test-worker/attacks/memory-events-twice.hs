data Again = Again Int deriving (Show)

main = simulate twice

twice :: Again -> [Again]
twice (Again n) = [Again (n + 1), Again (n + 2)]
