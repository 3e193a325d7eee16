data Alarm = Alarm Int String

watch :: Cliff -> Alarm
watch (Cliff side Hole) = Alarm 3 ("hole " ++ show side)
watch (Cliff _ Floor) = Alarm 0 "fine"

shout :: Alarm -> Maybe Say
shout (Alarm 0 _) = Nothing
shout (Alarm n text) | n > 2 = Just (Say (text ++ "!!!"))
                     | n > 1 = Just (Say text)
shout _ = Nothing

main :: IO ()
main = simulate (watch, shout)
