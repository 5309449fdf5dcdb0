package org.dfra.river.entry;

import java.util.List;
import net.jini.core.entry.Entry;

/**
 * Supplies entry classes of another part of DFRA, or of a third party, for records of its own.
 * {@link java.util.ServiceLoader} finds it: a jar names its implementation in {@code
 * META-INF/services/org.dfra.river.entry.EntryClassProvider}.
 *
 * <p>The module that creates the entries needs it. A client that reads an entry needs only the
 * entry's class, which may be downloaded.
 */
public interface EntryClassProvider {

  /**
   * Classes with {@link Mirrors}, a subclass before its superclass. They take precedence over those
   * of this package, which they may extend.
   */
  List<Class<? extends Entry>> entryClasses();
}
