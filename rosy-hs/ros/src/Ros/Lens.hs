-- |
-- Module      : Ros.Lens
-- Description : Reading and changing a field deep inside a message.
--
-- > twist ^. linear . Vector3.x
-- > def & linear . Vector3.x .~ 0.5
--
-- Just enough to use the lenses of the generated messages, which any lens library understands.
module Ros.Lens
  ( Lens,
    (^.),
    view,
    (.~),
    set,
    (%~),
    over,
    (&),
  )
where

import Data.Function ((&))
import Data.Functor.Const (Const (..))
import Data.Functor.Identity (Identity (..))

type Lens s a = forall f. Functor f => (a -> f a) -> s -> f s

infixl 8 ^.

infixr 4 .~, %~

(^.) :: s -> ((a -> Const a a) -> s -> Const a s) -> a
s ^. l = getConst (l Const s)

-- | > view l s = s ^. l
view :: ((a -> Const a a) -> s -> Const a s) -> s -> a
view l s = s ^. l

(.~) :: ((a -> Identity a) -> s -> Identity s) -> a -> s -> s
l .~ x = runIdentity . l (const (Identity x))

-- | > set l x = l .~ x
set :: ((a -> Identity a) -> s -> Identity s) -> a -> s -> s
set = (.~)

(%~) :: ((a -> Identity a) -> s -> Identity s) -> (a -> a) -> s -> s
l %~ g = runIdentity . l (Identity . g)

-- | > over l g = l %~ g
over :: ((a -> Identity a) -> s -> Identity s) -> (a -> a) -> s -> s
over = (%~)
