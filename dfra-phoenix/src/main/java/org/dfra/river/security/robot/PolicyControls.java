package org.dfra.river.security.robot;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.InvalidObjectException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.UUID;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.call.RobotAuthentication;

/** Exports {@link PolicyControl} under an identity that is known, and finds it there. */
public final class PolicyControls {

  /** The identity of {@link PolicyControl} in each process. It is no secret. */
  private static final Uuid IDENTITY = identity("b1a5f2a6-3c8e-4f5b-8d59-0c1f6c7b9a43");

  private static final Duration DEADLINE = Duration.ofSeconds(2);

  private final PolicyControl control;

  @GuardedBy("this")
  private final Set<String> exported = new HashSet<>(); // hosts

  /** For a process of a robot. */
  public PolicyControls(RobotState robot) {
    this.control = robot.control();
  }

  private static Uuid identity(String text) {
    UUID uuid = UUID.fromString(text);
    return UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
  }

  /**
   * Exports it at the port of everything else that the process exports at a host. Does nothing the
   * second time.
   *
   * @param host address of this computer, as in its proxies
   */
  public synchronized void export(String host) throws ExportException {
    if (exported.add(host)) {
      Exporter exporter =
          JeriExporters.notKeepingAlive(
              Endpoints.tcp(host, 0), new DeadlineILFactory(DEADLINE.toMillis()), IDENTITY);
      Remote unused = exporter.export(control);
    }
  }

  /**
   * That of a robot's process, which only the robot answers.
   *
   * @param robot the robot's name
   * @param process where the process exports its modules
   * @throws InvalidObjectException if no robot can have the name
   */
  public static PolicyControl of(String robot, PeerAddress process) throws InvalidObjectException {
    return RobotAuthentication.require(
        robot,
        (PolicyControl)
            DeadlineILFactory.proxy(
                new BasicObjectEndpoint(
                    Endpoints.tcpClient(process.host(), process.port()), IDENTITY, false),
                DEADLINE,
                PolicyControls.class.getClassLoader(),
                PolicyControl.class,
                RemoteMethodControl.class));
  }
}
