{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.TopicConnections
-- Description : Topics that a program connects its own types to, read off the parsed tree (rule R23).
--
-- Nothing runs: a name is known where it is a text, a definition of one, or several of them joined. Definitions that the instance uses are followed.
module Rosy.Worker.Ghc.TopicConnections
  ( topicConnections,
  )
where

import Data.Data (Data, cast, gmapQ)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import GHC.Data.Bag (isEmptyBag)
import GHC.Data.FastString (unpackFS)
import GHC.Hs
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (RdrName, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.DeclaredTypes (instanceHead)
import Rosy.Worker.Graph (Connection (..), ConnectionUse (..))

-- | In the order of the text: one for each instance of @Sensor@ or @Command@ that has methods.
topicConnections :: SyntaxTree -> [Connection]
topicConnections parsed =
  [ Connection (Text.pack t) use (Text.pack <$> name) (Text.pack <$> kind) (Text.pack <$> nub (concatMap fieldsIn reached))
    | L _ d@(InstD _ (ClsInstD _ i)) <- hsmodDecls parsed,
      not (isEmptyBag (cid_binds i)),
      let reached = map Code (bindList (cid_binds i)) ++ used (concatMap namesIn (bindList (cid_binds i))),
      (c, t) : _ <- [instanceHead d],
      Just (use, function) <- [lookup c [("Sensor", (Taken, "topic")), ("Command", (Sent, "publish"))]],
      let (name, kind) = case concatMap (\(Code x) -> callsOf function x) reached of
            (n, k) : _ -> (absolute <$> textOf n, textOf k)
            [] -> (Nothing, Nothing)
  ]
  where
    definitions :: Map.Map String (LHsBind GhcPs)
    definitions = Map.fromList [(n, L at b) | L at (ValD _ b) <- hsmodDecls parsed, n <- map plain (boundNames b)]
    -- The definitions that are used, also by one another.
    used :: [String] -> [Code]
    used names = [Code b | n <- go [] names, Just b <- [Map.lookup n definitions]]
      where
        go seen [] = reverse seen
        go seen (n : rest)
          | n `elem` seen = go seen rest
          | Just b <- Map.lookup n definitions = go (n : seen) (rest ++ namesIn b)
          | otherwise = go seen rest
    absolute n = if take 1 n == "/" then n else '/' : n
    textOf = go (16 :: Int)
      where
        -- The depth ends a recursion.
        go :: Int -> LHsExpr GhcPs -> Maybe String
        go depth (L _ e)
          | depth == 0 = Nothing
          | otherwise = case e of
            HsLit _ (HsString _ s) -> Just (unpackFS s)
            HsOverLit _ OverLit {ol_val = HsIsString _ s} -> Just (unpackFS s)
            Paren x -> go (depth - 1) x
            ExprWithTySig _ x _ -> go (depth - 1) x
            OpApp _ a (L _ (HsVar _ (L _ op))) b | plain op `elem` ["++", "<>"] -> (++) <$> go (depth - 1) a <*> go (depth - 1) b
            HsApp _ (L _ (HsVar _ (L _ f))) (L _ (ListOf xs)) | plain f `elem` ["concat", "mconcat"] -> concat <$> mapM (go (depth - 1)) xs
            HsVar _ (L _ n) | Just b <- Map.lookup (plain n) definitions, Just x <- valueOf (unLoc b) -> go (depth - 1) x
            _ -> Nothing

-- | A piece of the tree of any type.
data Code where
  Code :: Data a => a -> Code

-- | The right side of a definition without parameters, guards and local definitions.
valueOf :: HsBind GhcPs -> Maybe (LHsExpr GhcPs)
valueOf b = case b of
  FunBind {fun_matches = MG {mg_alts = L _ [L _ m]}} | null (m_pats m) -> only (m_grhss m)
  PatBind {pat_rhs = right} -> only right
  _ -> Nothing
  where
    only right = case (localBindings right, grhssGRHSs right) of
      (EmptyLocalBinds _, [L _ (GRHS _ [] x)]) -> Just x
      _ -> Nothing

-- | The first two arguments of each call of a function.
callsOf :: Data a => String -> a -> [(LHsExpr GhcPs, LHsExpr GhcPs)]
callsOf wanted x = case cast x of
  Just (HsApp _ (L _ (HsApp _ (L _ (HsVar _ (L _ f))) a)) b :: HsExpr GhcPs) | plain f == wanted -> [(a, b)]
  _ -> concat (gmapQ (callsOf wanted) x)

-- | The paths that the code reads with @field@.
fieldsIn :: Code -> [String]
fieldsIn (Code code) = go code
  where
    go :: Data a => a -> [String]
    go x = case cast x of
      Just (HsApp _ (L _ (HsVar _ (L _ f))) (L _ (HsLit _ (HsString _ s))) :: HsExpr GhcPs) | plain f == "field" -> [unpackFS s]
      _ -> concat (gmapQ go x)

-- | Every variable of an expression.
namesIn :: Data a => a -> [String]
namesIn x = case cast x of
  Just (HsVar _ (L _ n) :: HsExpr GhcPs) -> [plain n]
  _ -> concat (gmapQ namesIn x)

plain :: RdrName -> String
plain = occNameString . rdrNameOcc
