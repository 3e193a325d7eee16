newtype Parser a = Parser { parse :: String -> Maybe (a, String) }
instance Functor Parser where
  fmap f (Parser p) = Parser (\s -> case p s of { Nothing -> Nothing; Just (x, r) -> Just (f x, r) })
instance Applicative Parser where
  pure x = Parser (\s -> Just (x, s))
  Parser pf <*> Parser px = Parser (\s -> case pf s of { Nothing -> Nothing; Just (f, r) -> case px r of { Nothing -> Nothing; Just (x, r') -> Just (f x, r') } })
instance Monad Parser where
  Parser p >>= f = Parser (\s -> p s >>= \(x, r) -> parse (f x) r)
char :: Parser Char
char = Parser (\s -> case s of { (c : r) -> Just (c, r); [] -> Nothing })
move :: Parser Velocity
move = do { c <- char; d <- char; pure (if c == 'f' then Velocity (fromIntegral (fromEnum d - 48) / 10) 0 else Velocity 0 1) }
script :: String -> [Velocity]
script s = case parse move s of { Just (v, r) -> v : script r; Nothing -> [] }
main = simulate (mapM_ (\v -> once v >> wait 0.2) (script "f3r1f2") >> say "there")
