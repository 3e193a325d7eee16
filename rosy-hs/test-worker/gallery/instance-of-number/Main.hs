instance Sensor Int

main = simulate shout

shout :: Int -> Sound
shout _ = ErrorSound
