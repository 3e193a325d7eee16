data M1 a = M1 a
data M2 a = M2 a

data M = Start | Ignore Seconds

mux :: Seconds -> Memory M -> Either (M1 a) (M2 a) -> Maybe (a, Memory M)
mux now _ (Left (M1 a)) = Just (a, Memory (Ignore (now + 0.5)))
mux now (Memory (Ignore till)) (Right (M2 a))
  | now > till = Just (a, Memory Start)
  | otherwise = Nothing
mux now (Memory Start) (Right (M2 a)) = Just (a, Memory Start)

main :: IO ()
main = simulate mux
