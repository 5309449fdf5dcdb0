package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.flow.effector.Effector;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.entry.Entries;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.lookup.EffectorSearch.ListedEffector;
import org.dfra.river.transport.ServerNotAcceptedException;
import org.jspecify.annotations.Nullable;

/**
 * Reads the effectors of one lookup service, robot by robot, so that no answer is large.
 *
 * <p>A query that is not answered in time is repeated after all others: twice in all, and further
 * while there is time.
 *
 * <p>Threads: {@code dfra-search-id}, {@value #THREADS} for each lookup service until it is closed.
 * Each answer has at most {@value #LIMIT} effectors. If a robot has more of them, they are read by
 * their names.
 */
final class RegistrarEffectorReader implements AutoCloseable {

  private static final int THREADS = 4;
  private static final int LIMIT = 64;

  /** The least number of attempts for a query that is not answered. */
  private static final int TRIES = 2;

  /** If many calls to a peer hang, the next ones fail immediately as if they were not answered. */
  private static final long PAUSE_MILLIS = 250;

  /** Limit of effectors with one name on one robot; a legitimate robot has one. */
  private static final int LIMIT_OF_ONE_NAME = 8;

  private final ServiceRegistrar registrar;
  private final UUID key = UUID.randomUUID(); // its service ID may be a copy of another's
  private final List<String> wanted;
  private final List<String> known;
  private final EffectorSearch.Listener listener;
  private final Runnable changed;
  private final BooleanSupplier isTimeLeft;
  private final ExecutorService threads;
  private final Executor later; // delayed, on these threads

  // robots
  @GuardedBy("this")
  private final Set<String> begun = new LinkedHashSet<>();

  @GuardedBy("this")
  private final Set<String> faults = new LinkedHashSet<>();

  // queries without an answer
  @GuardedBy("this")
  private int pending;

  /**
   * @param wanted robots that are read; all if empty
   * @param known robots that are read first
   * @param loader context class loader of the reading threads
   * @param onChange is called when the reading is complete
   * @param isTimeLeft whether a query that failed twice is repeated
   */
  RegistrarEffectorReader(
      ServiceRegistrar registrar,
      List<String> wanted,
      List<String> known,
      EffectorSearch.Listener listener,
      @Nullable ClassLoader loader,
      Runnable onChange,
      BooleanSupplier isTimeLeft) {
    this.registrar = registrar;
    this.wanted = wanted;
    this.known = known;
    this.listener = listener;
    this.changed = onChange;
    this.isTimeLeft = isTimeLeft;
    String name = "dfra-search-" + registrar.getServiceID();
    this.threads =
        Executors.newFixedThreadPool(
            THREADS,
            task -> {
              Thread thread = new Thread(task, name);
              thread.setDaemon(true);
              thread.setContextClassLoader(loader);
              return thread;
            });
    this.later = CompletableFuture.delayedExecutor(PAUSE_MILLIS, TimeUnit.MILLISECONDS, threads);
  }

  private interface RemoteQuery {
    void ask() throws RemoteException;
  }

  /** Starts reading. */
  void start() {
    submit(this::locate);
    if (wanted.isEmpty()) {
      known.forEach(this::begin);
      submit(() -> values(template(null, null), "robot").forEach(this::begin));
    } else {
      wanted.forEach(this::begin);
    }
  }

  private void submit(RemoteQuery question) {
    synchronized (this) {
      pending++;
    }
    submit(question, 1, threads);
  }

  private void submit(RemoteQuery question, int tries, Executor executor) {
    try {
      executor.execute(
          () -> {
            if (!isAnswered(question, tries)) {
              submit(question, tries + 1, later);
            } else {
              answered();
            }
          });
    } catch (RejectedExecutionException e) { // closed
      answered();
    }
  }

  /**
   * Sends one query. An unanswered one is repeated behind all others, since an overloaded computer,
   * this one or the other, may need more time than a call has.
   *
   * @return whether it must not be repeated
   */
  private boolean isAnswered(RemoteQuery question, int tries) {
    try {
      question.ask();
      return true;
    } catch (DeadlineExceededException e) {
      if (!threads.isShutdown() && (tries < TRIES || isTimeLeft.getAsBoolean())) {
        return false;
      }
      fault(e);
    } catch (RemoteException | RuntimeException | Error e) { // the others are still sent
      fault(e);
    }
    return true;
  }

  private void fault(Throwable e) {
    fault(
        ServerNotAcceptedException.reason(e)
            .orElse("it did not answer (" + e.getClass().getSimpleName() + ")"));
  }

  private void answered() {
    synchronized (this) {
      pending--;
    }
    changed.run();
  }

  private synchronized void fault(String what) {
    faults.add(what);
  }

  private void locate() throws RemoteException {
    @Nullable LookupLocator locator = registrar.getLocator();
    if (locator != null) {
      listener.registrarFound(key, locator.getHost());
    }
  }

  /** Starts reading a robot, once. */
  private void begin(String robot) {
    synchronized (this) {
      if (!begun.add(robot)) {
        return;
      }
    }
    submit(() -> readRobot(robot));
  }

  private void readRobot(String robot) throws RemoteException {
    ServiceTemplate its = template(robot, null);
    if (publish(registrar.lookup(its, LIMIT))) {
      return;
    }
    for (String name : values(its, "name")) {
      submit(
          () -> {
            ServiceMatches matches = registrar.lookup(template(robot, name), LIMIT_OF_ONE_NAME);
            if (!publish(matches)) {
              fault(
                  "it lists "
                      + matches.totalMatches
                      + " effectors "
                      + robot
                      + "/"
                      + name
                      + ", of which "
                      + LIMIT_OF_ONE_NAME
                      + " were called");
            }
          });
    }
  }

  private List<String> values(ServiceTemplate template, String field) throws RemoteException {
    @Nullable Object[] values;
    try {
      values = registrar.getFieldValues(template, 0, field);
    } catch (NoSuchFieldException e) {
      throw new AssertionError(e);
    }
    List<String> texts = new ArrayList<>();
    for (@Nullable Object value : values == null ? new Object[0] : values) {
      if (value instanceof String text) {
        texts.add(text);
      }
    }
    return texts;
  }

  private static ServiceTemplate template(@Nullable String robot, @Nullable String name) {
    ModuleEntry of = new ModuleEntry();
    of.robot = robot;
    of.name = name;
    return new ServiceTemplate(null, new Class<?>[] {Effector.class}, new Entry[] {of});
  }

  /** Whether these were all matches. */
  private boolean publish(ServiceMatches matches) {
    for (ServiceItem item : matches.items) {
      try {
        publish(item);
      } catch (RuntimeException e) { // an unknown registrant's item must not hide later ones
        fault("an effector cannot be read (" + e.getClass().getSimpleName() + ")");
      }
    }
    return matches.totalMatches <= matches.items.length;
  }

  private void publish(ServiceItem item) {
    List<Attributes> attributes = Entries.toAttributes(item.attributeSets);
    for (Attributes each : attributes) {
      if (each instanceof ModuleAttributes own) {
        ServiceID id = item.serviceID;
        listener.found(
            new ListedEffector(
                ServiceTable.uuid(id),
                key,
                own.robot(),
                own.name(),
                item.service instanceof Effector<?> effector ? effector : null,
                attributes));
        return;
      }
    }
  }

  /** Whether every query was sent and answered. */
  synchronized boolean isOver() {
    return pending == 0;
  }

  /** What was not read and why, a sentence each. */
  synchronized List<String> unread() {
    List<String> sentences = new ArrayList<>();
    for (String fault : faults) {
      sentences.add(sentence(fault));
    }
    if (pending > 0) {
      sentences.add(sentence("it was not read to its end: " + pending + " questions are open"));
    }
    return sentences;
  }

  private String sentence(String fault) {
    return "not every effector of lookup service " + registrar + " was called: " + fault;
  }

  /** Closes the reader without waiting for running calls. */
  @Override
  public void close() {
    threads.shutdownNow();
  }
}
