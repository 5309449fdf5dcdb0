package org.dfra.river.phoenix.stop;

import java.time.Duration;
import java.util.UUID;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.filter.SerialLimits;

/** Finds the stop service of a computer's phoenix without any lookup service. */
public final class StopLocator {

  /** Default TCP port of phoenix. */
  public static final int DEFAULT_PORT = 1198;

  /**
   * The identity under which every phoenix exports its stop service. It is no secret and never
   * changes, since every client that reaches phoenix's port may stop effectors.
   */
  public static final Uuid IDENTITY = identity("2d6f3f1e-0c55-4f0a-8f3b-6a1d6a2f5707");

  private StopLocator() {}

  private static Uuid identity(String text) {
    UUID uuid = UUID.fromString(text);
    return UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
  }

  /**
   * Returns a proxy of a phoenix's stop service. Sends nothing before its first call. Refuses an
   * answer that exceeds {@link SerialLimits#STOP_REPORT}, since the server is not authenticated.
   *
   * @param host where phoenix runs
   * @param port its TCP port
   * @param deadline the longest wait for each answer, at least a millisecond
   */
  public static StopService proxyAt(String host, int port, Duration deadline) {
    return (StopService)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(Endpoints.tcpClient(host, port), IDENTITY, false),
            deadline,
            SerialLimits.STOP_REPORT,
            StopLocator.class.getClassLoader(),
            StopService.class);
  }
}
