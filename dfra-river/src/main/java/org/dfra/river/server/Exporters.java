package org.dfra.river.server;

import java.rmi.activation.ActivationID;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jrmp.JrmpExporter;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.ResurrectingExporter;
import org.jspecify.annotations.Nullable;

/**
 * Exporters for module servers, to be named in a module's Jini configuration:
 *
 * <pre>
 *   org.dfra.river.server {
 *       serverExporter = Exporters.jeri((ServerSettings) $data, 2000L);
 *   }
 * </pre>
 */
public final class Exporters {

  private Exporters() {}

  /**
   * JERI over TCP on a port of the system's choice; calls have a deadline, and the proxy brings an
   * activatable server back when it is dead.
   *
   * @param deadlineMillis how long an answer is awaited, in milliseconds, at least 1
   */
  public static Exporter jeri(ServerSettings settings, long deadlineMillis) {
    Exporter plain = jeri(settings.host(), deadlineMillis);
    return settings.id() == null ? plain : new ResurrectingExporter(settings.id(), plain);
  }

  /** The same for an object that is not activatable. */
  public static Exporter jeri(String host, long deadlineMillis) {
    return new BasicJeriExporter(
        Endpoints.tcp(host, 0), new DeadlineILFactory(deadlineMillis), false, true);
  }

  /**
   * JRMP, the protocol of plain Java RMI, instead of JERI, for clients that have nothing else: on
   * one address, with the deadline as the longest silence. The proxy of an activatable server
   * brings it back. A client with filters reads the proxy only where {@code
   * -Ddfra.serial.jrmp=true} is set.
   *
   * @param deadlineMillis how long an answer is awaited, in milliseconds, at least 1
   */
  public static Exporter jrmp(ServerSettings settings, long deadlineMillis) {
    JrmpSockets sockets = new JrmpSockets(settings.host(), Math.toIntExact(deadlineMillis));
    Exporter plain = new JrmpCallsExporter(new JrmpExporter(0, sockets, sockets), settings.host());
    return settings.id() == null ? plain : new ResurrectingExporter(settings.id(), plain);
  }

  /**
   * What a module's Jini configuration gets as {@code $data}.
   *
   * @param id the server's activation ID, or null where no activation system made it
   * @param host address or name that its proxies carry
   */
  public record ServerSettings(@Nullable ActivationID id, String host) {}
}
