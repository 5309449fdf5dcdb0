package org.dfra.river.security.news;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.function.Supplier;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.core.time.BoundedThreads;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.security.news.TeamNews.Numbers;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Exchanges with other processes what the authority of the team has published: the older of both
 * takes over what the newer one has.
 *
 * <p>Threads: at most {@value #THREADS} daemons, {@code dfra-news-n}, which end when idle.
 */
public final class NewsExchange {

  private static final Logger LOG = LoggerFactory.getLogger(NewsExchange.class);

  /** The identity of {@link TeamNews} in each process. It is no secret. */
  private static final Uuid IDENTITY = identity("5e2f3a0c-4c7b-4b1e-9a55-0d3f0f6f7a21");

  private static final int THREADS = 4;
  private static final int IDLE_SECONDS = 10;
  private static final Duration DEADLINE = Duration.ofSeconds(2);

  private final NewsFiles files;
  private final Supplier<Numbers> own;
  private final NewsService service;
  private final ThreadPoolExecutor threads =
      BoundedThreads.create("dfra-news-", THREADS, IDLE_SECONDS);

  /** What other processes had after the last exchange. */
  @GuardedBy("this")
  private final Map<PeerAddress, Numbers> known = new HashMap<>();

  @GuardedBy("this")
  private final Set<PeerAddress> underWay = new HashSet<>();

  @GuardedBy("this")
  private final Set<String> exported = new HashSet<>(); // hosts

  /**
   * @param folder with the identity
   * @param authority of the team
   * @param own what is in force in this process
   */
  public NewsExchange(Path folder, X509Certificate authority, Supplier<Numbers> own) {
    this.files = new NewsFiles(folder, authority);
    this.own = own;
    this.service = new NewsService(files, own);
  }

  private static Uuid identity(String text) {
    UUID uuid = UUID.fromString(text);
    return UuidFactory.create(uuid.getMostSignificantBits(), uuid.getLeastSignificantBits());
  }

  /**
   * Exports this process's part at the port of everything else that it exports at a host. Does
   * nothing the second time.
   *
   * @param host address of this computer, as in its proxies
   */
  public synchronized void export(String host) throws ExportException {
    if (exported.add(host)) {
      Exporter exporter =
          JeriExporters.notKeepingAlive(
              Endpoints.tcp(host, 0), new DeadlineILFactory(DEADLINE.toMillis()), IDENTITY);
      Remote unused = exporter.export(service);
    }
  }

  /**
   * Exchanges with a process, unless it is known to have the same. Does not wait.
   *
   * @param process where it exports something
   */
  public void with(PeerAddress process) {
    synchronized (this) {
      if (own.get().equals(known.get(process)) || !underWay.add(process)) {
        return;
      }
    }
    try {
      threads.execute(() -> exchange(process));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn("News are not exchanged with {} for now: {}", process, e.toString());
      synchronized (this) {
        underWay.remove(process);
      }
    }
  }

  /**
   * Exchanges with a process now, and returns what is in force there. Every call takes 2 s at most;
   * what the process has just been given is in force there a little later.
   *
   * @param process where it exports something
   * @throws IOException if it cannot be asked, or does not take what the authority has signed
   */
  public Numbers exchangeNow(PeerAddress process) throws IOException {
    TeamNews news = proxy(process);
    Numbers unused = exchange(news);
    return news.numbers();
  }

  private static TeamNews proxy(PeerAddress process) {
    return (TeamNews)
        DeadlineILFactory.proxy(
            new BasicObjectEndpoint(
                Endpoints.tcpClient(process.host(), process.port()), IDENTITY, false),
            DEADLINE,
            NewsExchange.class.getClassLoader(),
            TeamNews.class);
  }

  /** What is in force in this process. */
  public Numbers own() {
    return own.get();
  }

  private void exchange(PeerAddress process) {
    Numbers theirs = null;
    try {
      theirs = exchange(proxy(process));
    } catch (IOException | RuntimeException e) { // it is asked again at the next occasion
      LOG.debug("No exchange of news with {}.", process, e);
    } finally {
      synchronized (this) {
        underWay.remove(process);
        if (theirs != null) {
          known.put(process, theirs);
        }
      }
    }
  }

  /** Returns what the other one has afterwards. */
  Numbers exchange(TeamNews other) throws IOException {
    Numbers mine = own.get();
    Numbers theirs = other.numbers();
    if (theirs.revocations() > mine.revocations()) {
      files.storeRevocations(other.revocations());
    } else if (theirs.revocations() < mine.revocations()) {
      other.takeRevocations(files.revocations());
    }
    if (theirs.policy() > mine.policy()) {
      files.storePolicy(other.policy());
    } else if (theirs.policy() < mine.policy()) {
      other.takePolicy(files.policy());
    }
    return new Numbers(
        Math.max(mine.revocations(), theirs.revocations()),
        Math.max(mine.policy(), theirs.policy()));
  }
}
