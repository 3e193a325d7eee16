-- Projekt der Klasse 9c: Staubsauger mit Punkten
-- Jede Gruppe hat einen Teil geschrieben!

-------------------------- Gruppe 1: Typen --------------------------
data Zustand = Suchen | Wenden Double | Zurueck Seconds | Fertig
   deriving (Show,Eq)

data Ereignis = Punkt Int
              | Alarm String
              | Runde
type Punkte=Int

-------------------------- Gruppe 2: Sensoren -----------------------
stoss :: Bumper -> (Memory Zustand, Led1, Maybe Ereignis)
stoss (Bumper LeftBumper Pressed)   = (Memory (Wenden (-1.5)), Led1 Orange, Just (Punkt 1))
stoss (Bumper RightBumper Pressed)  = (Memory (Wenden 1.5), Led1 Orange, Just (Punkt 1))
stoss (Bumper CenterBumper Pressed) = (Memory (Wenden 3), Led1 Red, Just (Punkt 2))
stoss _ = (Memory Suchen, Led1 Black, Nothing)

loch :: Cliff -> Seconds -> (Memory Zustand, Maybe Ereignis)
loch (Cliff _ Hole) t = (Memory (Zurueck (t+1)), Just (Alarm "Loch!"))
loch (Cliff _ Floor) _ = (Memory Suchen, Nothing)

angehoben :: Wheel -> [Ereignis]
angehoben w = case w of
    Wheel LeftWheel  Air -> [Alarm "links", Punkt (-5)]
    Wheel RightWheel Air -> [Alarm "rechts", Punkt (-5)]
    _                    -> []

-------------------------- Gruppe 3: Fahren -------------------------
fahren :: Memory Zustand -> Seconds -> Velocity
fahren (Memory z) jetzt = f z
  where f Suchen = Velocity 0.3 (sin (alsZahl jetzt) * 0.2)
        f (Wenden w) | w > 0 = Velocity 0 1
                     | w < 0 = Velocity 0 (-1)
                     | otherwise = Velocity 0 0
        f (Zurueck ende) = if jetzt < ende then Velocity (-0.2) 0
                           else Velocity 0 0
        f Fertig = Velocity 0 0
        -- Sekunden sind auch nur Zahlen
        alsZahl (Seconds s) = s

-------------------------- Gruppe 4: Punkte -------------------------
zaehlen :: Ereignis -> Memory Punkte -> (Memory Punkte, Maybe Say)
zaehlen e (Memory p) =
    case e of
        Punkt n ->
            let neu = p + n
                text = "Punkte: " ++ show neu
            in (Memory neu, if neu `mod` 10 == 0 then Just (Say text) else Nothing)
        Alarm wo -> (Memory (p - 1), Just (Say ("Hilfe, " ++ wo)))
        Runde -> (Memory (p * 2), Just (Say "doppelt!"))

preis :: Punkte -> String
preis p
    | p >= 100 = "Gold"
    | p >= 50
    , p < 100 = "Silber"
    | p > 10 && p < 50 = "Bronze"
    | otherwise = "nichts :("

ende :: Button -> Memory Punkte -> (Memory Zustand, Say)
ende (Button Button0 Pressed) (Memory p) = (Memory Fertig, Say $ "Preis: " ++ preis p)
ende _ _ = (Memory Suchen, Say "weiter")

-------------------------- Gruppe 5: Licht --------------------------
farben :: [LedColor]
farben = [Black, Green, Orange, Red]

licht :: Memory Punkte -> Led2
licht (Memory p) = Led2 $ farben !! min 3 (max 0 (p `div` 10))

-- Tests von Hand
test1 = preis 100 == "Gold"
test2 = [preis p | p <- [0, 20 .. 120]]
test3 = and [p == q | (p, q) <- zip test2 ["nichts :(", "Bronze", "Bronze", "Silber", "Silber", "Gold", "Gold"]]

-------------------------- Alles zusammen ---------------------------
main :: IO ()
main = simulate ((stoss, loch, angehoben), (fahren, zaehlen), (ende, licht))
