package org.dfra.river.security.news;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.rmi.server.ExportException;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.dfra.core.audit.HeadStore;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.time.BoundedThreads;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.call.ProcessObject;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.security.news.TeamNews.Numbers;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Exchanges with other processes what the authority of the team has published: the older of both
 * takes over what the newer one has. Also exchanges the ends of audit trails, which both keep.
 *
 * <p>Threads: at most {@value #THREADS} daemons, {@code dfra-news-n}, which end when idle.
 */
public final class NewsExchange {

  private static final Logger LOG = LoggerFactory.getLogger(NewsExchange.class);

  private static final ProcessObject<TeamNews> NEWS =
      new ProcessObject<>(
          "5e2f3a0c-4c7b-4b1e-9a55-0d3f0f6f7a21", TeamNews.class, Duration.ofSeconds(2));

  private static final int THREADS = 4;
  private static final int IDLE_SECONDS = 10;

  /** Heads of audit trails are exchanged with a robot this often. */
  public static final Duration HEADS_PERIOD = Duration.ofSeconds(60);

  /** Another process of the robot exchanged them in the same period. */
  private static final Duration RECENT = HEADS_PERIOD.minusSeconds(5);

  private final NewsFiles files;
  private final HeadFiles heads;
  private final Supplier<Numbers> own;
  private final String team;
  private final String ownRobot; // empty for a person
  private final ProcessObject<TeamNews>.Own service;
  private final ThreadPoolExecutor threads =
      BoundedThreads.create("dfra-news-", THREADS, IDLE_SECONDS);

  /** What other processes had after the last exchange. */
  @GuardedBy("this")
  private final Map<PeerAddress, Numbers> known = new HashMap<>();

  /** When heads were last exchanged with a robot, by its name; by System.nanoTime. */
  @GuardedBy("this")
  private final Map<String, Long> headsTried = new HashMap<>();

  @GuardedBy("this")
  private final Set<PeerAddress> underWay = new HashSet<>();

  /**
   * @param folder with the identity, in the state folder
   * @param authority of the team
   * @param identity of this process
   * @param own what is in force in this process
   * @param taken puts in force what was just stored in the folder
   */
  public NewsExchange(
      Path folder,
      X509Certificate authority,
      TeamIdentity identity,
      Supplier<Numbers> own,
      Runnable taken) {
    this.files = new NewsFiles(folder, authority, taken);
    Path state = Objects.requireNonNull(folder.toAbsolutePath().getParent());
    this.heads = new HeadFiles(state, identity, InstantSource.system());
    this.own = own;
    this.team = identity.member().team();
    this.ownRobot = identity.robot();
    this.service = NEWS.own(new NewsService(files, heads, own));
  }

  /**
   * Exports this process's part at the port of everything else that it exports at a host. Does
   * nothing the second time.
   *
   * @param host address of this computer, as in its proxies
   */
  public void export(String host) throws ExportException {
    service.export(host);
  }

  /**
   * Exchanges with a process, unless it is known to have the same and the heads of audit trails are
   * not due. Does not wait.
   *
   * @param robot whose process it says that it is
   * @param process where it exports something
   */
  public void with(String robot, PeerAddress process) {
    boolean areHeadsDue;
    synchronized (this) {
      areHeadsDue = areHeadsDue(robot);
      boolean isSame = own.get().equals(known.get(process));
      if ((isSame && !areHeadsDue) || !underWay.add(process)) {
        return;
      }
      if (areHeadsDue) {
        headsTried.put(robot, System.nanoTime());
      }
    }
    try {
      threads.execute(() -> exchange(robot, process, areHeadsDue));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn("News are not exchanged with {} for now: {}", process, e.toString());
      synchronized (this) {
        underWay.remove(process);
      }
    }
  }

  /**
   * Exchanges with a process now, and returns what is in force there then. Every call takes 2 s at
   * most.
   *
   * @param process where it exports something
   * @throws IOException if it cannot be asked, or does not take what the authority has signed
   */
  public Numbers exchangeNow(PeerAddress process) throws IOException {
    TeamNews news = NEWS.of(process);
    Numbers unused = exchange(news);
    return news.numbers();
  }

  /** What is in force in this process. */
  public Numbers own() {
    return own.get();
  }

  @GuardedBy("this")
  private boolean areHeadsDue(String robot) {
    if (robot.equals(ownRobot)) {
      return false; // its head beside its trail proves nothing
    }
    @Nullable Long tried = headsTried.get(robot);
    return tried == null
        ? headsTried.size() < HeadStore.MOST_HEADS // as many robots can be kept
        : System.nanoTime() - tried >= HEADS_PERIOD.toNanos();
  }

  private void exchange(String robot, PeerAddress process, boolean areHeadsDue) {
    Numbers theirs = null;
    try {
      TeamNews news = NEWS.of(process);
      theirs = exchange(news);
      if (areHeadsDue && !heads.isRecent("robot " + robot + " of " + team, RECENT)) {
        exchangeHeads(news);
      }
    } catch (IOException | RuntimeException e) { // it is asked again at the next occasion
      LOG.debug("No exchange of news with {}.", process, e);
    } finally {
      synchronized (this) {
        underWay.remove(process);
        if (theirs != null) {
          known.put(process, theirs);
        }
        notifyAll();
      }
    }
  }

  /**
   * Waits until no exchange is under way, such as at the end of a command.
   *
   * @param patience longest time that this waits
   * @throws InterruptedException if this thread is interrupted
   */
  public synchronized void awaitExchanges(Duration patience) throws InterruptedException {
    long end = System.nanoTime() + patience.toNanos();
    long left = patience.toNanos();
    while (!underWay.isEmpty() && left > 0) {
      TimeUnit.NANOSECONDS.timedWait(this, left);
      left = end - System.nanoTime();
    }
  }

  /** Gives another process the ends of the own audit trails, and keeps those of its own. */
  void exchangeHeads(TeamNews other) throws IOException {
    heads.take(other.exchangeHeads(heads.own()));
  }

  /**
   * The ends of a member's audit trails that another process keeps.
   *
   * @param process where it exports something
   * @param member such as {@code robot atrv1 of field}
   * @throws IOException if it does not answer, or with something else
   */
  public static List<KeptHead> keptBy(PeerAddress process, String member) throws IOException {
    return HeadStore.parse(NEWS.of(process).keptHeads(member), "the answer of " + process);
  }

  /**
   * Publishes the end of this process's audit trail: others get it by the next exchanges. Does not
   * wait.
   *
   * @param sign signs it; throws if the trail cannot be written now
   */
  public void publishHead(Callable<KeptHead> sign) {
    try {
      threads.execute(() -> publish(sign));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn("The end of the audit trail is not signed for now: {}", e.toString());
    }
  }

  private void publish(Callable<KeptHead> sign) {
    try {
      heads.writeOwn(sign.call());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (Exception e) { // it is signed again in the next period
      LOG.warn("The end of the audit trail is not signed: {}", e.getMessage());
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
