package org.dfra.river.access;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.UnknownHostException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Guards an object that is exported without a {@link GuardedDispatcher}, for example by JRMP. The
 * guard is exported in place of the object. It refuses administrative calls from unauthorised
 * clients on the network; calls in this virtual machine are not checked.
 */
public final class AdministrationGuard {

  private AdministrationGuard() {}

  /**
   * The guard of an object.
   *
   * @param impl the object
   * @param host the address that it will be exported at, or a name of it
   * @return implements all remote interfaces of the object; keep a reference to it as long as it is
   *     exported
   * @throws ExportException if the host is unknown, or the configured addresses are invalid
   */
  public static Remote of(Remote impl, String host) throws ExportException {
    AdministrationPolicy policy;
    try {
      policy = AdministrationPolicy.exportedAt(host);
    } catch (UnknownHostException | IllegalArgumentException e) {
      throw new ExportException("it cannot be guarded at host " + host + ": " + e.getMessage(), e);
    }
    Class<?>[] interfaces = remoteInterfaces(impl.getClass());
    List<Method> methods = new ArrayList<>();
    for (Class<?> each : interfaces) {
      methods.addAll(Arrays.asList(each.getMethods()));
    }
    Set<Method> administrative = AdministrativeMethods.among(methods, impl.getClass());
    return (Remote)
        Proxy.newProxyInstance(
            impl.getClass().getClassLoader(),
            interfaces,
            (guard, method, arguments) -> {
              if (administrative.contains(method)) {
                Optional<RemoteCaller> caller = RemoteCaller.current();
                if (caller.isPresent()) {
                  policy.check(caller.get(), GuardedDispatcher.name(method));
                }
              }
              try {
                return method.invoke(impl, arguments);
              } catch (InvocationTargetException e) {
                throw e.getCause() == null ? e : e.getCause();
              }
            });
  }

  private static Class<?>[] remoteInterfaces(Class<?> type) {
    return AdministrativeMethods.interfaces(type).stream()
        .filter(Remote.class::isAssignableFrom)
        .toArray(Class<?>[]::new);
  }
}
