package org.dfra.directory;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.module.Module;

/**
 * Finds modules by their capabilities. The directory answers from its cache, so queries need no
 * network and never block, except {@link #findFirst}, which waits up to its timeout.
 */
public interface ModuleDirectory extends AutoCloseable {

  /**
   * The modules that match, the best first: one that works before one that has failed or stopped,
   * then the nearest, then one that is not stale, then by robot and name.
   */
  <M extends Module> List<ModuleListing<M>> find(ModuleQuery<M> query);

  /**
   * The best module that matches, waiting for one if there is none.
   *
   * @param timeout how long to wait
   * @return empty if none was found in time
   */
  <M extends Module> Optional<ModuleListing<M>> findFirst(ModuleQuery<M> query, Duration timeout)
      throws InterruptedException;

  /**
   * The best module of a kind itself, waiting for one if there is none.
   *
   * @param timeout how long to wait
   * @return empty if none was found in time
   */
  default <M extends Module> Optional<M> find(Class<M> kind, Duration timeout)
      throws InterruptedException {
    return findFirst(ModuleQuery.of(kind), timeout).map(ModuleListing::module);
  }

  /**
   * Notifies a listener of the modules that match, until the registration or the directory is
   * closed.
   */
  <M extends Module> DirectoryRegistration listen(
      ModuleQuery<M> query, DirectoryListener<M> listener);

  /**
   * Every robot that has published a module or a persona, by name and host. Robots of the same name
   * on two hosts are listed separately.
   */
  List<Persona> personas();

  /**
   * A proxy for all modules that match: each call goes to the module that answered last, or else to
   * the best match. If the remote call fails or the module is not ready, an {@link
   * org.dfra.module.Idempotent} call is repeated once, on another module if there is one. Any other
   * call is never repeated: the exception states whether it may have been executed ({@link
   * CallFailedException}). If nothing matches at the time of a call, it throws {@link
   * NoModuleFoundException}.
   */
  <M extends Module> M proxyFor(ModuleQuery<M> query);

  /** Closes the directory: it stops notifying listeners and clears its cache. */
  @Override
  void close();
}
