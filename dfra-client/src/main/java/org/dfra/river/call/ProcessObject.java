package org.dfra.river.call;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.UUID;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;

/**
 * A kind of remote object that processes export under the same ID, which is no secret: who knows
 * where a process exports anything can call it there, without a lookup.
 *
 * @param <T> its remote interface
 */
public final class ProcessObject<T extends Remote> {

  private final Uuid id;
  private final Class<T> type;
  private final Duration deadline;

  /**
   * @param id of the object in each process
   * @param deadline of each call
   */
  public ProcessObject(String id, Class<T> type, Duration deadline) {
    UUID uuid = UUID.fromString(id);
    this.id = UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
    this.type = type;
    this.deadline = deadline;
  }

  /**
   * A proxy for that of another process, which may be called with constraints. Nothing is sent.
   *
   * @param process where the process exports anything
   */
  public T of(PeerAddress process) {
    return type.cast(
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(Endpoints.tcpClient(process.host(), process.port()), id, false),
            deadline,
            type.getClassLoader(),
            type,
            RemoteMethodControl.class));
  }

  /** How this process exports its own one. */
  public Own own(T object) {
    return new Own(object);
  }

  /** That of this process. Thread-safe. */
  public final class Own {

    private final T object;

    @GuardedBy("this")
    private final Set<String> hosts = new HashSet<>();

    private Own(T object) {
      this.object = object;
    }

    /**
     * Exports it at the port of everything else that the process exports at a host. Does nothing
     * the second time.
     *
     * @param host address of this computer, as in its proxies
     */
    public void export(String host) throws ExportException {
      export(host, 0);
    }

    /**
     * The same at another port of this process.
     *
     * @param port TCP port; 0 for that of everything that is exported at no other
     */
    public synchronized void export(String host, int port) throws ExportException {
      if (hosts.add(host)) {
        Remote unused =
            JeriExporters.notKeepingAlive(
                    Endpoints.tcp(host, port), new DeadlineILFactory(deadline.toMillis()), id)
                .export(object);
      }
    }
  }
}
