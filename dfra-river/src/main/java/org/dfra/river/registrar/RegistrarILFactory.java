package org.dfra.river.registrar;

import java.lang.reflect.Method;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.util.Collection;
import net.jini.jeri.InvocationDispatcher;
import net.jini.jeri.ServerCapabilities;
import org.dfra.river.call.DeadlineILFactory;
import org.jspecify.annotations.Nullable;

/**
 * The invocation layer of a registrar: {@link DeadlineILFactory} with {@link RegistrationRules} in
 * front of reggie.
 *
 * <p>In a Jini configuration file:
 *
 * <pre>
 *   JeriExporters.keepingAlive(endpoint, new RegistrarILFactory(2000L, robot, moduleHosts))
 * </pre>
 */
public final class RegistrarILFactory extends DeadlineILFactory {

  private final RegistrationPolicy policy;

  /**
   * @param deadlineMillis the longest wait for an answer, in milliseconds, at least 1
   * @param robot name of the robot; empty for a registrar that belongs to no robot
   * @param from the robot's additional hosts, as {@link RegistrationPolicy#of} reads them
   * @throws IllegalArgumentException if those are malformed; the message has the remedy
   */
  public RegistrarILFactory(long deadlineMillis, String robot, String from) {
    this(Duration.ofMillis(deadlineMillis), RegistrationPolicy.of(robot, from));
  }

  /**
   * @param deadline the longest wait for an answer, at least a millisecond
   */
  public RegistrarILFactory(Duration deadline, RegistrationPolicy policy) {
    super(null, null, null, deadline);
    this.policy = policy;
  }

  /**
   * {@inheritDoc}
   *
   * @throws ExportException if the object is not reggie 2.2.2
   */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected InvocationDispatcher createInvocationDispatcher(
      Collection methods, Remote impl, ServerCapabilities capabilities) throws ExportException {
    return new RegistrarDispatcher(
        (Collection<Method>) methods,
        impl,
        capabilities,
        getServerConstraints(),
        getClassLoader(),
        policy);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return super.equals(other)
        && other instanceof RegistrarILFactory factory
        && factory.policy.equals(policy);
  }

  @Override
  public int hashCode() {
    return 31 * super.hashCode() + policy.hashCode();
  }
}
