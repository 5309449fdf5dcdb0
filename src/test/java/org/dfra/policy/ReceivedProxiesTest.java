package org.dfra.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Serializable;
import java.lang.reflect.Field;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import net.jini.core.lease.Lease;
import net.jini.io.MarshalledInstance;
import org.dfra.event.ModuleListener;
import org.junit.jupiter.api.Test;

/**
 * Each way by which a proxy reaches a process over the network, and what prepares the proxy before
 * its first call. A remote method that returns or takes something with a proxy in it needs a line.
 */
class ReceivedProxiesTest {

  /** Anything may be in them. */
  private static final Set<Class<?>> SERIALIZED =
      Set.of(MarshalledInstance.class, MarshalledObject.class);

  /** Proxies, and interfaces whose implementations have one. */
  private static final Set<Class<?>> CONTAINERS =
      Set.of(Remote.class, Lease.class, AutoCloseable.class, ModuleListener.class);

  /** What prepares them, by method and direction. Also prepared: what unicast discovery brings. */
  private static final Map<String, String> PREPARATIONS =
      Map.ofEntries(
          Map.entry(
              "ActivationInstantiator.newInstance returns",
              "phoenix hands it on and does not call it"),
          Map.entry(
              "ActivationMonitor.activeObject takes", "phoenix hands it on and does not call it"),
          Map.entry(
              "ActivationSystem.activeGroup takes", "PhoenixConfiguration, instantiatorPreparer"),
          Map.entry(
              "ActivationSystem.activeGroup returns",
              "of the group's own phoenix, which has the same key"),
          Map.entry(
              "Activator.activate returns",
              "LiveProxyHolder: the constraints of the proxy that was resurrected"),
          Map.entry(
              "Administrable.getAdmin returns",
              "ModuleProxy, PreparedProxies: the constraints of the module's proxy"),
          Map.entry("Effector.acquireCommandLease returns", "ProxyCommandLease, PreparedProxies"),
          Map.entry(
              "RemoteEffector.acquireCommandLease returns", "ProxyCommandLease, PreparedProxies"),
          Map.entry("Module.acquireLease returns", "ProxyLease, PreparedProxies"),
          Map.entry("RemoteModule.acquireLease returns", "ProxyLease, PreparedProxies"),
          Map.entry("Module.subscribe returns", "ProxySubscription, PreparedProxies"),
          Map.entry("RemoteModule.subscribe returns", "ProxySubscription, PreparedProxies"),
          Map.entry(
              "Module.subscribe takes", "CallbackProxies.withDeadline; any member may listen"),
          Map.entry(
              "RemoteModule.subscribe takes",
              "CallbackProxies.withDeadline; any member may listen"),
          Map.entry("PhoenixAdmin.activeProxy returns", "a module's proxy: ModuleProxy.readObject"),
          Map.entry(
              "Registrar.addAttributes takes", "the registrar stores it and does not call it"),
          Map.entry(
              "Registrar.modifyAttributes takes", "the registrar stores it and does not call it"),
          Map.entry(
              "Registrar.setAttributes takes", "the registrar stores it and does not call it"),
          Map.entry("Registrar.register takes", "the registrar stores it and does not call it"),
          Map.entry(
              "Registrar.cancelLeases takes",
              "Object[] of IDs, which ReggieArgumentValidator checks"),
          Map.entry(
              "Registrar.renewLeases takes",
              "Object[] of IDs, which ReggieArgumentValidator checks"),
          Map.entry(
              "Registrar.getEntryClasses takes", "templates, which are compared and not called"),
          Map.entry(
              "Registrar.getServiceTypes takes", "templates, which are compared and not called"),
          Map.entry("Registrar.lookup takes", "templates, which are compared and not called"),
          Map.entry("Registrar.getFieldValues returns", "values of entries, which are data"),
          Map.entry(
              "Registrar.lookup returns",
              "modules' proxies: ModuleProxy.readObject, RobotAuthentication"),
          Map.entry("Registrar.notify takes", "EventListenerPreparer"),
          Map.entry("Registrar.notify returns", "a lease of the registrar, which is any member's"),
          Map.entry(
              "RemoteEventListener.notify takes",
              "ServiceEvent: modules' proxies, ModuleProxy.readObject"),
          Map.entry(
              "RemoteRecruitmentAgent.notify takes",
              "messages of recruitment have no proxies: MethodTypes lets none in"),
          Map.entry(
              "ServiceProxyAccessor.getServiceProxy returns",
              "RegistrarPreparerConfiguration, registrarPreparer"));

  @Test
  void eachHasItsPreparation() {
    Set<String> found = new TreeSet<>();
    for (Class<?> each : RemoteInterfaces.WITH_SUPERINTERFACES) {
      for (Method method : RemoteInterfaces.declared(each)) {
        String name = each.getSimpleName() + "." + method.getName();
        Set<Type> seen = new HashSet<>();
        if (canHaveProxy(method.getGenericReturnType(), seen)) {
          found.add(name + " returns");
        }
        if (Arrays.stream(method.getGenericParameterTypes())
            .anyMatch(type -> canHaveProxy(type, seen))) {
          found.add(name + " takes");
        }
      }
    }
    assertThat(found)
        .as("a new way by which proxies arrive: prepare them before the first call, and add a line")
        .containsExactlyInAnyOrderElementsOf(PREPARATIONS.keySet());
  }

  /** Whether an object of a declared type can be or contain a proxy. */
  private static boolean canHaveProxy(Type type, Set<Type> seen) {
    if (!seen.add(type)) {
      return false;
    } else if (type instanceof ParameterizedType generic) {
      return canHaveProxy(generic.getRawType(), seen)
          || Arrays.stream(generic.getActualTypeArguments())
              .anyMatch(each -> canHaveProxy(each, seen));
    } else if (type instanceof WildcardType wildcard) {
      return Arrays.stream(wildcard.getUpperBounds())
          .anyMatch(each -> each != Object.class && canHaveProxy(each, seen));
    } else if (type instanceof GenericArrayType array) {
      return canHaveProxy(array.getGenericComponentType(), seen);
    }
    return type instanceof Class<?> known && canHaveProxy(known, seen);
  }

  private static boolean canHaveProxy(Class<?> type, Set<Type> seen) {
    if (type.isArray()) {
      return canHaveProxy((Type) type.getComponentType(), seen);
    } else if (type == Object.class
        || SERIALIZED.contains(type)
        || CONTAINERS.stream().anyMatch(each -> each.isAssignableFrom(type))) {
      return true;
    } else if (type.isPrimitive() || type.isEnum() || type.getName().startsWith("java.")) {
      return false;
    }
    return Arrays.stream(type.getDeclaredFields())
            .filter(ReceivedProxiesTest::isSent)
            .anyMatch(each -> canHaveProxy(each.getGenericType(), seen))
        || (type.getSuperclass() != null
            && Serializable.class.isAssignableFrom(type.getSuperclass())
            && canHaveProxy(type.getSuperclass(), seen));
  }

  private static boolean isSent(Field field) {
    return !Modifier.isStatic(field.getModifiers()) && !Modifier.isTransient(field.getModifiers());
  }
}
