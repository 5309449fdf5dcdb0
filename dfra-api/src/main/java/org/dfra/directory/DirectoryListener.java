package org.dfra.directory;

import org.dfra.module.Module;

/**
 * Is told of the modules that match a query. One call at a time, on a thread of the directory's; a
 * slow listener holds up nobody else, and learns of a module that changed several times meanwhile
 * only how it is at last.
 *
 * @param <M> the interface that is asked for
 */
public interface DirectoryListener<M extends Module> {

  /** A module matches that did not before. Those that match already when it begins come first. */
  void matched(ModuleListing<M> listing);

  /** A module that matches has changed: its attributes, its proxy, or whether it is stale. */
  default void changed(ModuleListing<M> before, ModuleListing<M> now) {}

  /** A module does not match any more, or is gone. */
  default void unmatched(ModuleListing<M> last) {}
}
