package org.dfra.benchmarks.secure;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Random;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.core.lease.Lease;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.benchmarks.task.Task;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.transport.TransportEndpoint;
import org.dfra.security.MemberRole;
import org.dfra.time.Scheduler;

/**
 * A robot's process, and members that are revoked one after the other: how long each can still call
 * on its open connection, and how long it keeps its lease. Each revocation begins at a random time
 * within the period in which the process looks at the list.
 */
public final class RevocationTask implements Task {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final Duration LEASE = Duration.ofSeconds(20);
  private static final long LOOK_AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(1);
  private static final int PERIOD_MILLIS = 250;
  private static final double NANOS_PER_MILLI = 1e6;

  /** For {@link TaskProcess}. */
  public RevocationTask() {}

  /**
   * How fast a revocation is in force, in milliseconds from the replacement of the list.
   *
   * @param handshakes how long a member's first connection took
   * @param calls until the next call was refused
   * @param leases until the lease had ended
   */
  public record Result(double[] handshakes, double[] calls, double[] leases) {}

  /** Revokes so many members in a process of its own. */
  public static Result measure(int tries) throws Exception {
    List<double[]> lines = new ArrayList<>();
    try (TaskProcess process = TaskProcess.start(RevocationTask.class, Integer.toString(tries))) {
      for (int i = 0; i < tries; i++) {
        String[] words = process.awaitLine("try ", PATIENCE).split(" ");
        lines.add(Stream.of(words).skip(1).mapToDouble(Double::parseDouble).toArray());
      }
      int unused = process.awaitEnd(PATIENCE);
    }
    return new Result(column(lines, 0), column(lines, 1), column(lines, 2));
  }

  private static double[] column(List<double[]> lines, int index) {
    return lines.stream().mapToDouble(each -> each[index]).toArray();
  }

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    Path folder = Files.createTempDirectory("dfra-revocation-");
    try (BenchTeam team = BenchTeam.create(folder.resolve("authority"))) {
      Path server = team.join(folder.resolve("server"), MemberRole.ROBOT, "server");
      BenchTeam.install(server);
      try (Probe probe = new Probe()) {
        Random random = new Random(1);
        for (int i = 0; i < Integer.parseInt(args[0]); i++) {
          String name = "member" + i;
          Path member = team.join(folder.resolve(name), MemberRole.OPERATOR, name);
          TeamIdentity identity = BenchTeam.identity(member);
          LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(random.nextInt(PERIOD_MILLIS)));
          out.println(revoke(team, name, identity, probe, server));
        }
      }
    } finally {
      delete(folder);
    }
  }

  private static String revoke(
      BenchTeam team, String name, TeamIdentity identity, Probe probe, Path server)
      throws Exception {
    RevocationProbe proxy = probe.proxy(identity);
    long connecting = System.nanoTime();
    if (!proxy.answer()) {
      throw new IOException(name + " got another answer");
    }
    long connected = System.nanoTime();
    Lease lease = proxy.hold();
    UUID id = ModuleLandlord.id(lease);
    Path next = server.resolve("revoked.next");
    Files.write(next, team.revoke(name));
    long began = System.nanoTime();
    Files.move(
        next,
        server.resolve(SecurityFiles.REVOKED),
        StandardCopyOption.REPLACE_EXISTING,
        StandardCopyOption.ATOMIC_MOVE);
    long refused = 0;
    long ended = 0;
    while (refused == 0 || ended == 0) {
      if (refused == 0 && isRefused(proxy)) {
        refused = System.nanoTime();
      }
      if (ended == 0 && !probe.registry.contains(id)) {
        ended = System.nanoTime();
      }
      if (System.nanoTime() - began > PATIENCE.toNanos() / 2) {
        throw new IOException(name + " is revoked, and still called or held a lease");
      }
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
    }
    if (!isRefused(proxy)) {
      throw new IOException(name + " was refused, and then answered again");
    }
    return String.format(
        Locale.ROOT,
        "try %.3f %.3f %.3f",
        (connected - connecting) / NANOS_PER_MILLI,
        (refused - began) / NANOS_PER_MILLI,
        (ended - began) / NANOS_PER_MILLI);
  }

  private static boolean isRefused(RevocationProbe proxy) {
    try {
      return !proxy.answer();
    } catch (RemoteException | SecurityException e) {
      return true;
    }
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(path);
      }
    }
  }

  /** The called object, with the leases of its callers. */
  private static final class Probe implements RevocationProbe, AutoCloseable {

    private final LeaseRegistry registry =
        new LeaseRegistry(
            "server/probe",
            new LeaseTerms(LEASE, LEASE),
            InstantSource.system(),
            Scheduler.system(),
            clients -> {});

    private final ModuleLandlord landlord =
        new ModuleLandlord("server/probe", registry, exporter(UuidFactory.generate()), HOST);

    private final Uuid id = UuidFactory.generate();
    private final Exporter exporter = exporter(id);
    private final int port;

    Probe() throws IOException {
      landlord.start();
      port = Objects.requireNonNull(PeerAddress.of(exporter.export(this))).port();
    }

    private static Exporter exporter(Uuid id) {
      return JeriExporters.requireNoDistributedGc(
          new BasicJeriExporter(Endpoints.tcp(HOST, 0), new DeadlineILFactory(), false, true, id),
          "the probe");
    }

    RevocationProbe proxy(TeamIdentity client) throws Exception {
      return CurrentIdentity.callAs(
          client,
          () ->
              (RevocationProbe)
                  DeadlineILFactory.proxy(
                      new BasicObjectEndpoint(new TransportEndpoint(HOST, port), id, false),
                      DeadlineILFactory.DEFAULT_DEADLINE,
                      RevocationProbe.class.getClassLoader(),
                      RevocationProbe.class,
                      RemoteMethodControl.class));
    }

    @Override
    public boolean answer() {
      return true;
    }

    @Override
    public Lease hold() throws LeaseRefusedException {
      return landlord.grant(LEASE.toMillis(), LeaseRole.CLIENT, () -> {});
    }

    @Override
    public void close() {
      boolean unused = exporter.unexport(true);
      landlord.close();
      registry.close();
    }
  }
}
