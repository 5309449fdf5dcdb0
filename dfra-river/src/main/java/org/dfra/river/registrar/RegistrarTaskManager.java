package org.dfra.river.registrar;

import com.sun.jini.thread.TaskManager;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The threads of a lookup service, for the entry {@code taskManager} of {@code
 * com.sun.jini.reggie}.
 *
 * <p>Reggie has 50 threads for events, for connections and for multicast requests. Such a request
 * is a datagram. It can name any host, which reggie resolves and connects to, and any host can send
 * it from a forged address: 50 of them would block all threads for minutes. So requests have
 * {@value #THREADS} threads of their own here, and {@value #MAX_QUEUED_REQUESTS} may wait; more are
 * dropped. A client without a response finds the lookup service by its next announcement.
 *
 * <p>Threads: daemons, {@code dfra-discovery-request-n}, which end after 10 s without a request.
 */
public final class RegistrarTaskManager extends TaskManager {

  static final int THREADS = 4;
  static final int MAX_QUEUED_REQUESTS = 64;

  private static final int MOST = 50; // as in reggie, like the next
  private static final long IDLE_MILLIS = 15_000;

  /** Names of reggie's own classes for datagrams and for the responses to them. */
  private static final Set<String> REQUESTS = Set.of("DecodeRequestTask", "AddressTask");

  private final ThreadPoolExecutor requests;

  /** Called by a Jini configuration; a thread starts with the first task. */
  public RegistrarTaskManager() {
    super(MOST, IDLE_MILLIS, 1.0f);
    AtomicInteger number = new AtomicInteger();
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    requests =
        new ThreadPoolExecutor(
            THREADS,
            THREADS,
            10,
            TimeUnit.SECONDS,
            new ArrayBlockingQueue<>(MAX_QUEUED_REQUESTS),
            task -> {
              Thread thread =
                  new Thread(task, "dfra-discovery-request-" + number.incrementAndGet());
              thread.setDaemon(true);
              thread.setContextClassLoader(loader);
              return thread;
            },
            new ThreadPoolExecutor.DiscardPolicy());
    requests.allowCoreThreadTimeOut(true);
  }

  private static boolean isRequest(Task task) {
    return REQUESTS.contains(task.getClass().getSimpleName());
  }

  @Override
  public synchronized void add(Task task) {
    if (isRequest(task)) {
      requests.execute(task);
    } else {
      super.add(task);
    }
  }

  /** Adds a task, unless an equal one waits. */
  @Override
  public synchronized void addIfNew(Task task) {
    if (!isRequest(task)) {
      super.addIfNew(task);
    } else if (!requests.getQueue().contains(task)) {
      requests.execute(task);
    }
  }

  @Override
  public synchronized void terminate() {
    requests.shutdownNow();
    super.terminate();
  }
}
