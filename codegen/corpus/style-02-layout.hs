-- Layout in every way that Haskell allows.
move' :: Int -> Task ()
move' n = do { say "go"
             ; wait 1
             ; if n > 3
                 then say "many"
                 else say "few"
             ; rest }
  where rest = do
          wait 2
          say "rest"

choose :: Int -> Task ()
choose n =
  do say "choose"
     if n == 0 then
       say "none"
     else if n == 1 then do
       say "one"
       wait 1
     else
       say "more"
     case n of
          0 -> return ()
          1 -> do wait 1
                  say "again"
          _ | even n -> say "even"
            | otherwise
            -> say "odd"

semis :: Int -> Task ()
semis n = do
  if n > 0
    then say "up"
    else say "down"
  ; wait 1
  ; say "end"

oneLine :: Int -> Int
oneLine n = case n of { 0 -> 1; m | m < 0 -> -1 | otherwise -> m }

lets :: Int -> Int
lets n = let { a = n; b = a + 1 } in let c = b * 2
                                         d = c - 1 in c + d

deep :: Task ()
deep = do
  forM_ [1 .. 3 :: Int] $ \i -> do
    forM_ [i, i + 1 .. 5] $ \j ->
      when (i /= j) $ do
        say (show i)
        let k = i * j
            l = k + 1
        unless (k > l) $
          say (show k)
    wait 1
  say "done"

main = simulate deep
