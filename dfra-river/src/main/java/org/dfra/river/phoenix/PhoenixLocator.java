package org.dfra.river.phoenix;

import java.rmi.activation.ActivationSystem;
import java.time.Duration;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;

/** Finds the phoenix of a host without a registry: its identity is fixed, its port is known. */
public final class PhoenixLocator {

  private PhoenixLocator() {}

  /**
   * A proxy for the activation system of a host. Nothing is sent before its first call.
   *
   * @param host where phoenix runs; it answers registrations only to callers on that host
   * @param port its TCP port
   * @param deadline how long each answer is awaited
   * @return the proxy; it also implements {@link PhoenixAdmin}
   */
  public static ActivationSystem system(String host, int port, Duration deadline) {
    return (ActivationSystem)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(Endpoints.at(host, port), Identities.SYSTEM, false),
            deadline,
            PhoenixLocator.class.getClassLoader(),
            ActivationSystem.class,
            PhoenixAdmin.class,
            ReadinessMonitor.class,
            RemoteMethodControl.class,
            TrustEquivalence.class);
  }
}
