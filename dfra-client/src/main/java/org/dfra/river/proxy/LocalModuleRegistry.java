package org.dfra.river.proxy;

import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.module.Module;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.jspecify.annotations.Nullable;

/**
 * The modules whose implementations run in this virtual machine. A proxy here calls them as local
 * objects, if it has the same identity: robots that share a virtual machine call each other like
 * others. A server adds its module when it starts and removes it when it stops.
 */
public final class LocalModuleRegistry {

  private static final ConcurrentHashMap<UUID, Local> MODULES = new ConcurrentHashMap<>();

  /** A module, and the identity of its server. */
  private record Local(Module module, @Nullable ChannelIdentity identity) {}

  private LocalModuleRegistry() {}

  /**
   * Adds a module of the current identity.
   *
   * @throws IllegalStateException if another one has the same identity
   */
  public static void register(UUID id, Module module) {
    @Nullable Local other = MODULES.putIfAbsent(id, new Local(module, CurrentIdentity.get()));
    if (other != null && other.module() != module) {
      throw new IllegalStateException(
          module + " cannot serve as " + id + ": " + other.module() + " already does in this JVM");
    }
  }

  /** Removes a module. Does nothing if another one is registered. */
  public static void unregister(UUID id, Module module) {
    @Nullable Local known = MODULES.get(id);
    if (known != null && known.module() == module) {
      MODULES.remove(id, known);
    }
  }

  /** Whether the module's implementation runs in this virtual machine. */
  public static boolean contains(UUID id) {
    return MODULES.containsKey(id);
  }

  /**
   * The module's implementation, or null if it is remote.
   *
   * @param identity of the proxy that calls it
   */
  static @Nullable Module find(UUID id, @Nullable ChannelIdentity identity) {
    @Nullable Local local = MODULES.get(id);
    return local != null && local.identity() == identity ? local.module() : null;
  }
}
