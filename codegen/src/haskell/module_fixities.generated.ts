/// Made by scripts/fixities.ts from GHC; not edited by hand.

/// The operators with a fixity declaration that modules export; an operator of theirs that is absent is `infixl 9`.
export const moduleFixities: readonly {readonly modules: string; readonly fixities: string}[] = [
 {
  "modules": "Control.Applicative",
  "fixities": "infixl 3 <|>, infixl 4 *>, infixl 4 <$, infixl 4 <$>, infixl 4 <*, infixl 4 <**>, infixl 4 <*>"
 },
 {
  "modules": "Control.Applicative.Backwards Control.Applicative.Lift Control.Concurrent Control.Concurrent.Chan Control.Concurrent.MVar Control.Concurrent.QSem Control.Concurrent.QSemN Control.Concurrent.STM Control.Concurrent.STM.TArray Control.Concurrent.STM.TBQueue Control.Concurrent.STM.TChan Control.Concurrent.STM.TMVar Control.Concurrent.STM.TQueue Control.Concurrent.STM.TSem Control.Concurrent.STM.TVar Control.Exception Control.Exception.Base Control.Monad.Catch Control.Monad.Catch.Pure Control.Monad.Cont.Class Control.Monad.Error.Class Control.Monad.Fail Control.Monad.Fix Control.Monad.IO.Class Control.Monad.RWS.Class Control.Monad.Reader.Class Control.Monad.ST Control.Monad.ST.Lazy Control.Monad.ST.Lazy.Safe Control.Monad.ST.Lazy.Unsafe Control.Monad.ST.Safe Control.Monad.ST.Strict Control.Monad.ST.Unsafe Control.Monad.STM Control.Monad.Signatures Control.Monad.State.Class Control.Monad.Trans Control.Monad.Trans.Accum Control.Monad.Trans.Class Control.Monad.Trans.Cont Control.Monad.Trans.Error Control.Monad.Trans.Except Control.Monad.Trans.Identity Control.Monad.Trans.List Control.Monad.Trans.Maybe Control.Monad.Trans.RWS Control.Monad.Trans.RWS.CPS Control.Monad.Trans.RWS.Lazy Control.Monad.Trans.RWS.Strict Control.Monad.Trans.Reader Control.Monad.Trans.Select Control.Monad.Trans.State Control.Monad.Trans.State.Lazy Control.Monad.Trans.State.Strict Control.Monad.Trans.Writer Control.Monad.Trans.Writer.CPS Control.Monad.Trans.Writer.Lazy Control.Monad.Trans.Writer.Strict Control.Monad.Writer.Class Control.Monad.Zip Data.Array Data.Array.Base Data.Array.IArray Data.Array.IO Data.Array.IO.Internals Data.Array.IO.Safe Data.Array.MArray Data.Array.MArray.Safe Data.Array.ST Data.Array.ST.Safe Data.Array.Storable Data.Array.Storable.Internals Data.Array.Storable.Safe Data.Array.Unboxed Data.Array.Unsafe Data.Bifoldable Data.Bifunctor Data.Bitraversable Data.ByteString.Builder Data.ByteString.Builder.Extra Data.ByteString.Builder.Internal Data.ByteString.Internal Data.ByteString.Lazy.Builder Data.ByteString.Lazy.Builder.ASCII Data.ByteString.Lazy.Builder.Extras Data.ByteString.Lazy.Internal Data.ByteString.Short Data.ByteString.Short.Internal Data.ByteString.Unsafe Data.Char Data.Coerce Data.Containers.ListUtils Data.Dynamic Data.Either Data.Fixed Data.Functor.Classes Data.Functor.Const Data.Functor.Constant Data.Functor.Identity Data.Functor.Product Data.Functor.Reverse Data.Functor.Sum Data.Graph Data.IORef Data.Int Data.IntMap Data.IntMap.Internal Data.IntMap.Internal.Debug Data.IntMap.Lazy Data.IntMap.Merge.Lazy Data.IntMap.Merge.Strict Data.IntMap.Strict Data.IntMap.Strict.Internal Data.IntSet Data.IntSet.Internal Data.Ix Data.Kind Data.Map Data.Map.Internal Data.Map.Internal.Debug Data.Map.Lazy Data.Map.Merge.Lazy Data.Map.Merge.Strict Data.Map.Strict Data.Map.Strict.Internal Data.Maybe Data.Proxy Data.STRef Data.STRef.Lazy Data.STRef.Strict Data.Set Data.Set.Internal Data.String Data.Text.Array Data.Text.Encoding Data.Text.Encoding.Error Data.Text.Foreign Data.Text.IO Data.Text.Internal.Builder Data.Text.Internal.Builder.Int.Digits Data.Text.Internal.Builder.RealFloat.Functions Data.Text.Internal.ByteStringCompat Data.Text.Internal.Encoding.Fusion Data.Text.Internal.Encoding.Fusion.Common Data.Text.Internal.Encoding.Utf16 Data.Text.Internal.Encoding.Utf32 Data.Text.Internal.Encoding.Utf8 Data.Text.Internal.Functions Data.Text.Internal.Fusion Data.Text.Internal.Fusion.CaseMapping Data.Text.Internal.Fusion.Common Data.Text.Internal.Fusion.Size Data.Text.Internal.IO Data.Text.Internal.Lazy Data.Text.Internal.Lazy.Encoding.Fusion Data.Text.Internal.Lazy.Fusion Data.Text.Internal.Lazy.Search Data.Text.Internal.PrimCompat Data.Text.Internal.Private Data.Text.Internal.Read Data.Text.Internal.Search Data.Text.Internal.Unsafe Data.Text.Internal.Unsafe.Char Data.Text.Internal.Unsafe.Shift Data.Text.Lazy.Builder Data.Text.Lazy.Builder.Int Data.Text.Lazy.Builder.RealFloat Data.Text.Lazy.Encoding Data.Text.Lazy.IO Data.Text.Lazy.Internal Data.Text.Lazy.Read Data.Text.Read Data.Text.Unsafe Data.Time Data.Time.Calendar Data.Time.Calendar.Easter Data.Time.Calendar.Julian Data.Time.Calendar.MonthDay Data.Time.Calendar.OrdinalDate Data.Time.Calendar.WeekDate Data.Time.Clock Data.Time.Clock.POSIX Data.Time.Clock.System Data.Time.Clock.TAI Data.Time.Format Data.Time.Format.ISO8601 Data.Time.Format.Internal Data.Time.LocalTime Data.Traversable Data.Tree Data.Tuple Data.Type.Coercion Data.Unique Data.Version Data.Void Data.Word Debug.Trace Foreign.C Foreign.C.Error Foreign.C.String Foreign.C.Types Foreign.Concurrent Foreign.ForeignPtr Foreign.ForeignPtr.Safe Foreign.ForeignPtr.Unsafe Foreign.Marshal Foreign.Marshal.Alloc Foreign.Marshal.Array Foreign.Marshal.Error Foreign.Marshal.Pool Foreign.Marshal.Safe Foreign.Marshal.Unsafe Foreign.Marshal.Utils Foreign.Ptr Foreign.StablePtr Foreign.Storable GHC.Arr GHC.ByteOrder GHC.CString GHC.Char GHC.Clock GHC.Conc.IO GHC.Conc.Signal GHC.ConsoleHandler GHC.Constants GHC.Debug GHC.Desugar GHC.Enum GHC.Environment GHC.Err GHC.Event GHC.Event.TimeOut GHC.Exception GHC.Exception.Type GHC.ExecutionStack GHC.ExecutionStack.Internal GHC.Fingerprint GHC.Fingerprint.Type GHC.Float.ConversionUtils GHC.Float.RealFracMethods GHC.Foreign GHC.ForeignPtr GHC.GHCi GHC.GHCi.Helpers GHC.IO GHC.IO.Buffer GHC.IO.BufferedIO GHC.IO.Device GHC.IO.Encoding GHC.IO.Encoding.CodePage GHC.IO.Encoding.Failure GHC.IO.Encoding.Iconv GHC.IO.Encoding.Latin1 GHC.IO.Encoding.Types GHC.IO.Encoding.UTF16 GHC.IO.Encoding.UTF32 GHC.IO.Encoding.UTF8 GHC.IO.Exception GHC.IO.FD GHC.IO.Handle GHC.IO.Handle.FD GHC.IO.Handle.Internals GHC.IO.Handle.Lock GHC.IO.Handle.Text GHC.IO.Handle.Types GHC.IO.IOMode GHC.IO.StdHandles GHC.IO.Unsafe GHC.IOArray GHC.IOPort GHC.IORef GHC.Int GHC.IntWord64 GHC.Integer GHC.Integer.Logarithms GHC.Ix GHC.MVar GHC.Magic GHC.Maybe GHC.Natural GHC.OverloadedLabels GHC.Pack GHC.Prim GHC.Prim.Exception GHC.Prim.Ext GHC.Prim.Panic GHC.PrimopWrappers GHC.Profiling GHC.Ptr GHC.RTS.Flags GHC.Read GHC.Records GHC.ResponseFile GHC.ST GHC.STRef GHC.Show GHC.Stable GHC.StableName GHC.Stack GHC.Stack.CCS GHC.Stack.Types GHC.StaticPtr GHC.Stats GHC.Storable GHC.TopHandler GHC.Tuple GHC.Unicode GHC.Weak GHC.Word Numeric.Natural System.CPUTime System.Cmd System.Console.GetOpt System.Directory System.Directory.Internal System.Environment System.Environment.Blank System.Exit System.IO System.IO.Error System.IO.Unsafe System.Info System.Mem System.Mem.StableName System.Mem.Weak System.Posix.Internals System.Posix.Types System.Process System.Process.Internals System.Random System.Random.Internal System.Random.Stateful System.Timeout Text.Parsec.ByteString Text.Parsec.ByteString.Lazy Text.Parsec.Char Text.Parsec.Combinator Text.Parsec.Error Text.Parsec.Expr Text.Parsec.Language Text.Parsec.Pos Text.Parsec.String Text.Parsec.Text Text.Parsec.Text.Lazy Text.Parsec.Token Text.ParserCombinators.Parsec.Char Text.ParserCombinators.Parsec.Combinator Text.ParserCombinators.Parsec.Error Text.ParserCombinators.Parsec.Expr Text.ParserCombinators.Parsec.Language Text.ParserCombinators.Parsec.Pos Text.ParserCombinators.Parsec.Token Text.ParserCombinators.ReadPrec Text.Printf Text.Read Text.Read.Lex Text.Show Text.Show.Functions Type.Reflection.Unsafe Unsafe.Coerce Utils.Containers.Internal.BitQueue Utils.Containers.Internal.BitUtil",
  "fixities": ""
 },
 {
  "modules": "Control.Arrow",
  "fixities": "infixr 1 <<<, infixr 1 <<^, infixr 1 >>>, infixr 1 >>^, infixr 1 ^<<, infixr 1 ^>>, infixr 2 +++, infixr 2 |||, infixr 3 &&&, infixr 3 ***, infixr 5 <+>"
 },
 {
  "modules": "Control.Category",
  "fixities": "infixr 1 <<<, infixr 1 >>>, infixr 9 ."
 },
 {
  "modules": "Control.DeepSeq",
  "fixities": "infixl 4 <$!!>, infixr 0 $!!"
 },
 {
  "modules": "Control.Monad Control.Monad.Cont Control.Monad.Error Control.Monad.Except Control.Monad.Identity Control.Monad.List Control.Monad.Reader Control.Monad.State Control.Monad.State.Lazy Control.Monad.State.Strict",
  "fixities": "infixl 1 >>, infixl 1 >>=, infixl 4 <$, infixl 4 <$!>, infixr 1 <=<, infixr 1 =<<, infixr 1 >=>"
 },
 {
  "modules": "Control.Monad.Instances",
  "fixities": "infixl 1 >>, infixl 1 >>=, infixl 4 <$"
 },
 {
  "modules": "Control.Monad.RWS Control.Monad.RWS.Lazy Control.Monad.RWS.Strict Control.Monad.Writer Control.Monad.Writer.Lazy Control.Monad.Writer.Strict",
  "fixities": "infixl 1 >>, infixl 1 >>=, infixl 4 <$, infixl 4 <$!>, infixr 1 <=<, infixr 1 =<<, infixr 1 >=>, infixr 6 <>"
 },
 {
  "modules": "Data.Bits Foreign Foreign.Safe",
  "fixities": "infixl 5 .|., infixl 6 xor, infixl 7 .&., infixl 8 rotate, infixl 8 rotateL, infixl 8 rotateR, infixl 8 shift, infixl 8 shiftL, infixl 8 shiftR"
 },
 {
  "modules": "Data.Bool Data.Type.Bool",
  "fixities": "infixr 2 ||, infixr 3 &&"
 },
 {
  "modules": "Data.ByteString Data.ByteString.Char8",
  "fixities": "infixl 5 snoc, infixr 5 cons"
 },
 {
  "modules": "Data.ByteString.Builder.Prim Data.ByteString.Builder.Prim.Internal",
  "fixities": "infixl 4 >$<, infixr 5 >*<"
 },
 {
  "modules": "Data.ByteString.Lazy Data.ByteString.Lazy.Char8",
  "fixities": "infixl 5 snoc, infixr 5 cons, infixr 5 cons'"
 },
 {
  "modules": "Data.Complex",
  "fixities": "infix 6 :+"
 },
 {
  "modules": "Data.Data Data.Typeable Type.Reflection",
  "fixities": "infix 4 :~:, infix 4 :~~:"
 },
 {
  "modules": "Data.Eq",
  "fixities": "infix 4 /=, infix 4 =="
 },
 {
  "modules": "Data.Foldable",
  "fixities": "infix 4 elem, infix 4 notElem"
 },
 {
  "modules": "Data.Function",
  "fixities": "infixl 0 on, infixl 1 &, infixr 0 $, infixr 9 ."
 },
 {
  "modules": "Data.Functor",
  "fixities": "infixl 1 <&>, infixl 4 $>, infixl 4 <$, infixl 4 <$>"
 },
 {
  "modules": "Data.Functor.Compose",
  "fixities": "infixr 9 Compose"
 },
 {
  "modules": "Data.Functor.Contravariant",
  "fixities": "infixl 4 $<, infixl 4 >$, infixl 4 >$$<, infixl 4 >$<"
 },
 {
  "modules": "Data.List GHC.OldList",
  "fixities": "infix 4 elem, infix 4 notElem, infix 5 \\\\, infixr 5 ++"
 },
 {
  "modules": "Data.List.NonEmpty",
  "fixities": "infixr 5 :|, infixr 5 <|"
 },
 {
  "modules": "Data.Monoid Data.Semigroup",
  "fixities": "infixr 6 <>"
 },
 {
  "modules": "Data.Ord",
  "fixities": "infix 4 <, infix 4 <=, infix 4 >, infix 4 >="
 },
 {
  "modules": "Data.Ratio",
  "fixities": "infixl 7 %"
 },
 {
  "modules": "Data.Sequence Data.Sequence.Internal",
  "fixities": "infixl 5 :>, infixl 5 :|>, infixl 5 |>, infixr 5 :<, infixr 5 :<|, infixr 5 <|, infixr 5 ><"
 },
 {
  "modules": "Data.Sequence.Internal.Sorting",
  "fixities": "infixr 8 IQCons, infixr 8 ITQCons, infixr 8 QCons, infixr 8 TQCons"
 },
 {
  "modules": "Data.Text Data.Text.Lazy",
  "fixities": "infixr 5 cons"
 },
 {
  "modules": "Data.Text.Internal",
  "fixities": "infixl 7 mul, infixl 7 mul32, infixl 7 mul64"
 },
 {
  "modules": "Data.Text.Internal.Builder.Functions",
  "fixities": "infixr 4 <>"
 },
 {
  "modules": "Data.Text.Internal.Fusion.Types",
  "fixities": "infixl 2 :*:"
 },
 {
  "modules": "Data.Type.Equality",
  "fixities": "infix 4 :~:, infix 4 :~~:, infix 4 ==, infix 4 ~~"
 },
 {
  "modules": "GHC.Base",
  "fixities": "infix 4 /=, infix 4 <, infix 4 <=, infix 4 ==, infix 4 >, infix 4 >=, infix 4 ~~, infixl 1 >>, infixl 1 >>=, infixl 3 <|>, infixl 4 *>, infixl 4 <$, infixl 4 <*, infixl 4 <**>, infixl 4 <*>, infixr 0 $, infixr 0 $!, infixr 0 seq, infixr 1 =<<, infixr 2 ||, infixr 3 &&, infixr 5 ++, infixr 5 :|, infixr 6 <>, infixr 9 ."
 },
 {
  "modules": "GHC.Classes",
  "fixities": "infix 4 /=, infix 4 <, infix 4 <=, infix 4 ==, infix 4 >, infix 4 >=, infixr 2 ||, infixr 3 &&"
 },
 {
  "modules": "GHC.Conc GHC.Conc.Sync",
  "fixities": "infixr 0 par, infixr 0 pseq"
 },
 {
  "modules": "GHC.Exts",
  "fixities": "infix 4 ~~, infixr 0 seq"
 },
 {
  "modules": "GHC.Float Numeric",
  "fixities": "infixr 8 **"
 },
 {
  "modules": "GHC.Generics",
  "fixities": "infixr 5 :+:, infixr 6 :*:, infixr 7 :.:"
 },
 {
  "modules": "GHC.IO.SubSystem",
  "fixities": "infixl 7 <!>"
 },
 {
  "modules": "GHC.List",
  "fixities": "infix 4 elem, infix 4 notElem, infixr 5 ++"
 },
 {
  "modules": "GHC.Num",
  "fixities": "infixl 6 +, infixl 6 -, infixl 7 *"
 },
 {
  "modules": "GHC.Real",
  "fixities": "infixl 7 %, infixl 7 /, infixl 7 div, infixl 7 mod, infixl 7 quot, infixl 7 rem, infixr 8 ^, infixr 8 ^^"
 },
 {
  "modules": "GHC.TypeLits",
  "fixities": "infix 4 <=, infix 4 <=?, infixl 5 :$$:, infixl 6 +, infixl 6 -, infixl 6 :<>:, infixl 7 *, infixl 7 Div, infixl 7 Mod, infixr 8 ^"
 },
 {
  "modules": "GHC.TypeNats",
  "fixities": "infix 4 <=, infix 4 <=?, infixl 6 +, infixl 6 -, infixl 7 *, infixl 7 Div, infixl 7 Mod, infixr 8 ^"
 },
 {
  "modules": "GHC.Types",
  "fixities": "infix 4 ~~"
 },
 {
  "modules": "Prelude",
  "fixities": "infix 4 /=, infix 4 <, infix 4 <=, infix 4 ==, infix 4 >, infix 4 >=, infix 4 elem, infix 4 notElem, infixl 1 >>, infixl 1 >>=, infixl 4 *>, infixl 4 <$, infixl 4 <$>, infixl 4 <*, infixl 4 <*>, infixl 6 +, infixl 6 -, infixl 7 *, infixl 7 /, infixl 7 div, infixl 7 mod, infixl 7 quot, infixl 7 rem, infixr 0 $, infixr 0 $!, infixr 0 seq, infixr 1 =<<, infixr 2 ||, infixr 3 &&, infixr 5 ++, infixr 6 <>, infixr 8 **, infixr 8 ^, infixr 8 ^^, infixr 9 ."
 },
 {
  "modules": "System.Directory.Internal.Prelude",
  "fixities": "infix 4 /=, infix 4 <, infix 4 <=, infix 4 ==, infix 4 >, infix 4 >=, infix 4 elem, infix 4 notElem, infixl 0 on, infixl 1 >>, infixl 1 >>=, infixl 4 *>, infixl 4 <$, infixl 4 <$>, infixl 4 <*, infixl 4 <*>, infixl 5 .|., infixl 6 +, infixl 6 -, infixl 7 *, infixl 7 .&., infixl 7 /, infixl 7 div, infixl 7 mod, infixl 7 quot, infixl 7 rem, infixr 0 $, infixr 0 $!, infixr 0 seq, infixr 1 <=<, infixr 1 =<<, infixr 1 >=>, infixr 2 ||, infixr 3 &&, infixr 5 ++, infixr 6 <>, infixr 8 **, infixr 8 ^, infixr 8 ^^, infixr 9 ."
 },
 {
  "modules": "System.FilePath System.FilePath.Posix System.FilePath.Windows",
  "fixities": "infixr 5 </>, infixr 7 -<.>, infixr 7 <.>"
 },
 {
  "modules": "Text.Parsec Text.Parsec.Prim Text.ParserCombinators.Parsec Text.ParserCombinators.Parsec.Prim",
  "fixities": "infix 0 <?>, infixr 1 <|>"
 },
 {
  "modules": "Text.Parsec.Perm Text.ParserCombinators.Parsec.Perm",
  "fixities": "infixl 1 <|?>, infixl 1 <||>, infixl 2 <$$>, infixl 2 <$?>"
 },
 {
  "modules": "Text.ParserCombinators.ReadP",
  "fixities": "infixr 5 +++, infixr 5 <++"
 },
 {
  "modules": "Text.PrettyPrint Text.PrettyPrint.Annotated Text.PrettyPrint.Annotated.HughesPJ Text.PrettyPrint.Annotated.HughesPJClass Text.PrettyPrint.HughesPJ Text.PrettyPrint.HughesPJClass",
  "fixities": "infixl 5 $$, infixl 5 $+$, infixl 6 <+>, infixl 6 <>"
 },
 {
  "modules": "Utils.Containers.Internal.StrictPair",
  "fixities": "infixr 1 :*:"
 }
]
