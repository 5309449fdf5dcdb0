package org.dfra.river.proxy;

import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/**
 * The modules whose implementations live in this virtual machine, so that a proxy here calls them
 * as plain objects. A server enters its module when it serves and takes it out when it stops.
 */
public final class LocalModuleRegistry {

  private static final ConcurrentHashMap<UUID, Module> MODULES = new ConcurrentHashMap<>();

  private LocalModuleRegistry() {}

  /**
   * Enters a module.
   *
   * @throws IllegalStateException if another one is entered under the same identity
   */
  public static void register(UUID id, Module module) {
    Module other = MODULES.putIfAbsent(id, module);
    if (other != null && other != module) {
      throw new IllegalStateException(
          module + " cannot serve as " + id + ": " + other + " already does in this JVM");
    }
  }

  /** Takes a module out. Does nothing where it is not the one that is entered. */
  public static void unregister(UUID id, Module module) {
    MODULES.remove(id, module);
  }

  /** Whether the module's implementation lives in this virtual machine. */
  public static boolean contains(UUID id) {
    return MODULES.containsKey(id);
  }

  /** The module's implementation, or null where it lives elsewhere. */
  static @Nullable Module find(UUID id) {
    return MODULES.get(id);
  }
}
