import qualified Data.Set as Set

main = simulate (Say (show (Set.size (Set.powerSet (Set.fromList [1 .. 60 :: Int])))))
