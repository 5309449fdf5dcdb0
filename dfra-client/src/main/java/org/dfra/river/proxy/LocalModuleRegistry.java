package org.dfra.river.proxy;

import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/**
 * The modules whose implementations run in this virtual machine. A proxy here calls them as local
 * objects. A server adds its module when it starts and removes it when it stops.
 */
public final class LocalModuleRegistry {

  private static final ConcurrentHashMap<UUID, Module> MODULES = new ConcurrentHashMap<>();

  private LocalModuleRegistry() {}

  /**
   * Adds a module.
   *
   * @throws IllegalStateException if another one has the same identity
   */
  public static void register(UUID id, Module module) {
    Module other = MODULES.putIfAbsent(id, module);
    if (other != null && other != module) {
      throw new IllegalStateException(
          module + " cannot serve as " + id + ": " + other + " already does in this JVM");
    }
  }

  /** Removes a module. Does nothing if another one is registered. */
  public static void unregister(UUID id, Module module) {
    MODULES.remove(id, module);
  }

  /** Whether the module's implementation runs in this virtual machine. */
  public static boolean contains(UUID id) {
    return MODULES.containsKey(id);
  }

  /** The module's implementation, or null if it is remote. */
  static @Nullable Module find(UUID id) {
    return MODULES.get(id);
  }
}
