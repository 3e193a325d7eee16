-- Grüße aus der Schule
größe :: Double
größe = 0.5

α :: Double
α = größe * 2

名前 :: String
名前 = "ロボット"

fahre :: Velocity
fahre = Velocity größe α

main :: IO ()
main = simulate (fahre, Say ("Hallo, " ++ 名前 ++ " → 🤖"))
