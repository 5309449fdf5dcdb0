package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.util.Collection;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.InvocationDispatcher;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.ServerCapabilities;
import org.dfra.module.StopsRobot;
import org.dfra.river.access.GuardedDispatcher;
import org.dfra.river.filter.SerialLimits;
import org.dfra.river.transport.StopLane;
import org.jspecify.annotations.Nullable;

/**
 * JERI's invocation layer with a deadline on every call, filtered arguments, and a guard of
 * {@linkplain org.dfra.module.Administrative administrative} methods. DFRA's exporters are
 * configured with it.
 *
 * <p>In a Jini configuration file:
 *
 * <pre>
 *   exporter = JeriExporters.keepingAlive(endpoint, new DeadlineILFactory(2000L));
 * </pre>
 */
public class DeadlineILFactory extends BasicILFactory {

  /** The timeout of a call, if nothing else is configured. */
  public static final Duration DEFAULT_DEADLINE = Duration.ofSeconds(2);

  private final Duration deadline;

  /** Calls must be answered within {@link #DEFAULT_DEADLINE}. */
  public DeadlineILFactory() {
    this(DEFAULT_DEADLINE.toMillis());
  }

  /**
   * @param deadlineMillis timeout of a call, in milliseconds, at least 1
   */
  public DeadlineILFactory(long deadlineMillis) {
    this(null, null, null, Duration.ofMillis(deadlineMillis));
  }

  /**
   * @param server the server's constraints, or null for none
   * @param permission null. River checks a permission only under a security manager, which no
   *     longer exists: a call without the permission would be executed
   * @param loader the loader that defines the proxy, or null for the implementation's
   * @param deadline timeout of a call, at least a millisecond
   * @throws IllegalArgumentException if there is a permission class, or the deadline is shorter
   */
  public DeadlineILFactory(
      @Nullable MethodConstraints server,
      @Nullable Class<?> permission,
      @Nullable ClassLoader loader,
      Duration deadline) {
    super(server, requireNone(permission), loader);
    if (deadline.toMillis() < 1) {
      throw new IllegalArgumentException("deadline " + deadline + " is shorter than 1 ms");
    }
    this.deadline = deadline;
  }

  private static @Nullable Class<?> requireNone(@Nullable Class<?> permission) {
    if (permission != null) {
      throw new IllegalArgumentException(
          "permission class "
              + permission.getName()
              + " would guard nothing, since there is no security manager; mark what only"
              + " administrators may call with @Administrative, and name them in <administration"
              + " from=\"…\"> of the robot's XML");
    }
    return null;
  }

  /**
   * {@inheritDoc}
   *
   * @throws ExportException if the object cannot be exported, or its exporter uses distributed
   *     garbage collection
   */
  @Override
  protected InvocationHandler createInvocationHandler(
      Class[] interfaces, Remote impl, ObjectEndpoint endpoint) throws ExportException {
    JeriExporters.requireNoDistributedGc(endpoint, impl);
    EncryptedExport.require(endpoint, impl);
    super.createInvocationHandler(interfaces, impl, endpoint); // throws if it cannot be exported
    return new DeadlineInvocationHandler(endpoint, getServerConstraints(), deadline);
  }

  /** Refuses calls of unauthorised clients, and filters the arguments of all other calls. */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected InvocationDispatcher createInvocationDispatcher(
      Collection methods, Remote impl, ServerCapabilities capabilities) throws ExportException {
    Collection<Method> called = methods;
    called.stream()
        .filter(each -> each.isAnnotationPresent(StopsRobot.class))
        .forEach(StopLane::add);
    return new GuardedDispatcher(
        called, impl.getClass(), capabilities, getServerConstraints(), getClassLoader());
  }

  /**
   * A proxy for an object whose endpoint is known beforehand.
   *
   * @param endpoint the endpoint and identity of the exported object
   * @param deadline timeout of a call
   * @param loader the loader that defines the proxy
   * @param interfaces the interfaces of the proxy
   */
  public static Object proxy(
      ObjectEndpoint endpoint, Duration deadline, ClassLoader loader, Class<?>... interfaces) {
    return Proxy.newProxyInstance(
        loader, interfaces, new DeadlineInvocationHandler(endpoint, null, deadline));
  }

  /**
   * Creates a proxy for an object whose endpoint is known beforehand, if any program may send the
   * responses.
   *
   * @param endpoint the endpoint and identity of the exported object
   * @param deadline timeout of a call
   * @param answerLimits maximum size of a response
   * @param loader the loader that defines the proxy
   * @param interfaces the interfaces of the proxy
   */
  public static Object proxy(
      ObjectEndpoint endpoint,
      Duration deadline,
      SerialLimits answerLimits,
      ClassLoader loader,
      Class<?>... interfaces) {
    return Proxy.newProxyInstance(
        loader, interfaces, new DeadlineInvocationHandler(endpoint, null, deadline, answerLimits));
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return super.equals(other)
        && other instanceof DeadlineILFactory factory
        && factory.deadline.equals(deadline);
  }

  @Override
  public int hashCode() {
    return 31 * super.hashCode() + deadline.hashCode();
  }
}
