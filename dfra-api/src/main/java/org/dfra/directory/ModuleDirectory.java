package org.dfra.directory;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.module.Module;

/**
 * Finds modules by what they can do. Answers come from what the directory knows, so they need no
 * network and never wait, but for {@link #findFirst}, which waits as long as it is told to.
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
   * @return nothing where none was found in time
   */
  <M extends Module> Optional<ModuleListing<M>> findFirst(ModuleQuery<M> query, Duration timeout)
      throws InterruptedException;

  /**
   * The best module of a kind itself, waiting for one if there is none.
   *
   * @param timeout how long to wait
   * @return nothing where none was found in time
   */
  default <M extends Module> Optional<M> find(Class<M> kind, Duration timeout)
      throws InterruptedException {
    return findFirst(ModuleQuery.of(kind), timeout).map(ModuleListing::module);
  }

  /** Has a listener told of the modules that match, until the watch or the directory is closed. */
  <M extends Module> DirectoryRegistration listen(
      ModuleQuery<M> query, DirectoryListener<M> listener);

  /**
   * Every robot that has shown something of itself, by name and host. Two robots of one name on two
   * hosts are two.
   */
  List<Persona> personas();

  /**
   * A module that stands for all that match: each call goes to the one that answered last or else
   * the best. Where that fails as remote calls do, or the module is not ready, an {@link
   * org.dfra.module.Idempotent} call is made once more, on another module if there is one. Any
   * other call is never repeated: the error says whether it may have run ({@link
   * CallFailedException}). Where nothing matches at the time of a call, it throws {@link
   * NoModuleFoundException}.
   */
  <M extends Module> M proxyFor(ModuleQuery<M> query);

  /** Ends it: listeners hear no more, and what it knew is forgotten. */
  @Override
  void close();
}
