/// Map of maps: the entries of several maps as those of one, where a later map's entry hides an earlier one's.
///
/// Making it costs nothing per entry, so that an answer about a whole program can be put together from those about its definitions at each edit. Who asks for
/// many entries gets them from a map made then.

/// After so many questions one map is made of all.
const few = 100

export class LayeredMap<V> implements ReadonlyMap<string, V> {
  readonly #layers: readonly ReadonlyMap<string, V>[]
  #whole: ReadonlyMap<string, V> | undefined
  #asked = 0

  constructor(layers: readonly ReadonlyMap<string, V>[]) {
    this.#layers = layers
  }

  get(key: string): V | undefined {
    if (this.#whole === undefined && this.#asked++ < few)
      return this.#layers.findLast(layer => layer.has(key))?.get(key)
    return this.whole().get(key)
  }

  has(key: string): boolean {
    return this.whole().has(key)
  }

  get size(): number {
    return this.whole().size
  }

  forEach(each: (value: V, key: string, map: ReadonlyMap<string, V>) => void): void {
    this.whole().forEach(each)
  }

  entries() {
    return this.whole().entries()
  }

  keys() {
    return this.whole().keys()
  }

  values() {
    return this.whole().values()
  }

  [Symbol.iterator]() {
    return this.entries()
  }

  private whole(): ReadonlyMap<string, V> {
    this.#whole ??= new Map(this.#layers.flatMap(layer => [...layer]))
    return this.#whole
  }
}
