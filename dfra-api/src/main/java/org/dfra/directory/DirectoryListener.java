package org.dfra.directory;

import org.dfra.module.Module;

/**
 * Is notified of the modules that match a query. Calls are made one at a time, on a thread of the
 * directory. A slow listener delays no other listener. If a module changes several times meanwhile,
 * the listener receives only its last state.
 *
 * @param <M> the interface that is queried
 */
public interface DirectoryListener<M extends Module> {

  /** A module has begun to match. Modules that already match at registration are reported first. */
  void matched(ModuleListing<M> listing);

  /** A module that matches has changed: its attributes, its proxy, or whether it is stale. */
  default void changed(ModuleListing<M> before, ModuleListing<M> now) {}

  /** A module no longer matches, or has disappeared. */
  default void unmatched(ModuleListing<M> last) {}
}
