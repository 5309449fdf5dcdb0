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
import org.dfra.river.access.GuardedDispatcher;
import org.dfra.river.filter.SerialLimits;
import org.jspecify.annotations.Nullable;

/**
 * JERI's invocation layer with a deadline on every call, filtered arguments, and a guard in front
 * of {@linkplain org.dfra.module.Administrative administrative} methods: what DFRA's exporters are
 * configured with.
 *
 * <p>In a Jini configuration file:
 *
 * <pre>
 *   exporter = new BasicJeriExporter(endpoint, new DeadlineILFactory(2000L), false, true);
 * </pre>
 */
public class DeadlineILFactory extends BasicILFactory {

  /** How long an answer is awaited where nothing else is configured. */
  public static final Duration DEFAULT_DEADLINE = Duration.ofSeconds(2);

  private final Duration deadline;

  /** Calls that must be answered within {@link #DEFAULT_DEADLINE}. */
  public DeadlineILFactory() {
    this(DEFAULT_DEADLINE.toMillis());
  }

  /**
   * @param deadlineMillis how long an answer is awaited, in milliseconds, at least 1
   */
  public DeadlineILFactory(long deadlineMillis) {
    this(null, null, null, Duration.ofMillis(deadlineMillis));
  }

  /**
   * @param server the server's constraints, or null for none
   * @param permission null. River checks a permission only under a security manager, which there is
   *     none any more: a call that nobody was granted would be served
   * @param loader the loader that defines the proxy, or null for the implementation's
   * @param deadline how long an answer is awaited, at least a millisecond
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

  @Override
  protected InvocationHandler createInvocationHandler(
      Class[] interfaces, Remote impl, ObjectEndpoint endpoint) throws ExportException {
    super.createInvocationHandler(interfaces, impl, endpoint); // refuses what cannot be served
    return new DeadlineInvocationHandler(endpoint, getServerConstraints(), deadline);
  }

  /** Refuses what the client may not call, and filters the arguments of all other calls. */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected InvocationDispatcher createInvocationDispatcher(
      Collection methods, Remote impl, ServerCapabilities capabilities) throws ExportException {
    return new GuardedDispatcher(
        (Collection<Method>) methods,
        impl.getClass(),
        capabilities,
        getServerConstraints(),
        getClassLoader());
  }

  /**
   * A proxy for an object whose endpoint is known beforehand.
   *
   * @param endpoint where the object is exported, and under which identity
   * @param deadline how long an answer is awaited
   * @param loader the loader that defines the proxy
   * @param interfaces what the proxy implements
   */
  public static Object proxy(
      ObjectEndpoint endpoint, Duration deadline, ClassLoader loader, Class<?>... interfaces) {
    return Proxy.newProxyInstance(
        loader, interfaces, new DeadlineInvocationHandler(endpoint, null, deadline));
  }

  /**
   * A proxy for an object whose endpoint is known beforehand, and whose answers anybody may give.
   *
   * @param endpoint where the object is exported, and under which identity
   * @param deadline how long an answer is awaited
   * @param answerLimits how large an answer may be
   * @param loader the loader that defines the proxy
   * @param interfaces what the proxy implements
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
