data Knock = Knock deriving (Eq)

main = simulate Knock
