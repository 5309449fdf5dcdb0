package org.dfra.river.entry;

import java.util.List;
import net.jini.core.entry.Entry;

/**
 * Entry classes that another part of DFRA, or somebody else's, brings along for records of its own.
 * It is found by {@link java.util.ServiceLoader}: a jar names its implementation in {@code
 * META-INF/services/org.dfra.river.entry.EntryClassProvider}.
 *
 * <p>They are needed where entries are made, at the module. Who reads one needs its class only,
 * which may be downloaded.
 */
public interface EntryClassProvider {

  /**
   * Classes with {@link Mirrors}, a subclass before its superclass. They come before those of this
   * package, which they may extend.
   */
  List<Class<? extends Entry>> entryClasses();
}
