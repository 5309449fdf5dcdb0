package org.dfra.river.lookup;

import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import net.jini.core.lookup.ServiceItem;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.call.ResurrectingHandler;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;
import org.jspecify.annotations.Nullable;

/**
 * What one lookup service lists under one service ID: a module, a module that cannot be read here,
 * or a robot's own entry.
 *
 * @param path {@code robot/name} of a module, or the robot's name
 * @param module the module; null if it is none, or cannot be read
 * @param attributes all of them
 * @param unreadable the module that cannot be read; else null
 * @param robot the robot; null if it is a module
 * @param callTarget the object that its calls reach, for comparison without a call
 */
record ListedService(
    String path,
    @Nullable Module module,
    List<Attributes> attributes,
    @Nullable UnreadableModule unreadable,
    @Nullable PersonaAttributes robot,
    List<Object> callTarget) {

  ListedService {
    attributes = List.copyOf(attributes);
    callTarget = List.copyOf(callTarget);
  }

  /**
   * Reads an item.
   *
   * @param fault why its proxy could not be read, if it is missing
   * @return empty if it represents neither a module nor a robot
   */
  static Optional<ListedService> of(ServiceItem item, String fault) {
    List<Attributes> attributes = Entries.toAttributes(item.attributeSets);
    @Nullable ModuleAttributes own = first(attributes, ModuleAttributes.class);
    if (own != null) {
      String path = own.robot() + "/" + own.name();
      if (item.service instanceof Module module) {
        List<Object> callee = callTarget(module);
        callee.add(path);
        callee.add(own.host());
        return Optional.of(new ListedService(path, module, attributes, null, null, callee));
      } else if (item.service == null) {
        String id = ServiceTable.uuid(item.serviceID).toString();
        UnreadableModule unreadable =
            new UnreadableModule(own.robot(), own.name(), own.host(), id, fault);
        List<Object> callee = List.of(path, own.host());
        return Optional.of(new ListedService(path, null, attributes, unreadable, null, callee));
      }
    }
    @Nullable PersonaAttributes robot = first(attributes, PersonaAttributes.class);
    return robot == null
        ? Optional.empty()
        : Optional.of(
            new ListedService(robot.robot(), null, attributes, null, robot, List.of(robot)));
  }

  private static <A extends Attributes> @Nullable A first(List<Attributes> of, Class<A> kind) {
    for (Attributes each : of) {
      if (kind.isInstance(each)) {
        return kind.cast(each);
      }
    }
    return null;
  }

  /** Proxies of one service ID are equal; their call targets may differ. */
  private static List<Object> callTarget(Module module) {
    List<Object> callee = new ArrayList<>();
    if (module instanceof ModuleProxy<?> proxy) {
      RemoteModule server = proxy.server();
      if (Proxy.isProxyClass(server.getClass())
          && Proxy.getInvocationHandler(server) instanceof ResurrectingHandler handler) {
        callee.add(handler.activationID());
        @Nullable Remote live = handler.live(); // the registered one: no call has replaced it
        if (live != null) {
          callee.add(live);
        }
      } else {
        callee.add(server);
      }
    } else {
      callee.add(module.getClass());
    }
    return callee;
  }

  /** Whether its proxy can be read here. */
  boolean isReadable() {
    return unreadable == null;
  }

  /** Whether both are modules, or both robots. */
  boolean isSameKind(ListedService other) {
    return (robot == null) == (other.robot() == null);
  }

  /** Whether the other has the same call target and the same name. Makes no call. */
  boolean isSameAs(ListedService other) {
    try {
      return callTarget.equals(other.callTarget());
    } catch (RuntimeException e) { // an unknown registrant's proxy may throw anything
      return false;
    }
  }
}
