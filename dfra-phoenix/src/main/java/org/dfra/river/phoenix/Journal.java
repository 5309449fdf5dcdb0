package org.dfra.river.phoenix;

import com.sun.jini.reliableLog.ReliableLog;
import java.io.IOException;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.UnknownGroupException;
import java.util.function.Function;
import org.dfra.core.host.PrivateFiles;
import org.dfra.river.phoenix.host.ProcessLock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the registrations on disk: a snapshot and the changes since. It syncs each change before
 * the change takes effect. Thread-safe; its lock is acquired last.
 *
 * <p>A change that cannot be written (a full disk) does not take effect. Before the next change,
 * the journal is reopened from a snapshot of the effective registrations.
 */
final class Journal implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Journal.class);

  private static final String LOCK = "phoenix.lock";

  private final Path folder;
  private final ProcessLock lock;
  private final int snapshotThreshold;
  private final Registrations registrations;
  private @Nullable ReliableLog log; // null: reopened before the next change
  private int pending;
  private boolean closed;

  private Journal(
      Path folder,
      ProcessLock lock,
      int snapshotThreshold,
      JournalHandler recovered,
      ReliableLog log) {
    this.folder = folder;
    this.lock = lock;
    this.snapshotThreshold = snapshotThreshold;
    this.registrations = recovered.registrations();
    this.log = log;
  }

  /**
   * Reads the journal of a folder, or creates one there.
   *
   * @param snapshotThreshold changes after which a new snapshot is written
   * @throws IOException if it is damaged, the folder cannot be written or another daemon uses it
   */
  static Journal open(Path folder, int snapshotThreshold) throws IOException {
    try {
      PrivateFiles.makeFolder(folder);
      ProcessLock lock = ProcessLock.acquire(folder.resolve(LOCK), "this journal");
      try {
        return open(folder, lock, snapshotThreshold);
      } catch (IOException | RuntimeException e) {
        lock.close();
        throw e;
      }
    } catch (IOException | RuntimeException e) {
      throw new IOException(
          "The journal in "
              + folder
              + " cannot be used ("
              + innermost(e)
              + "); nothing was changed. Free space or correct the folder's permissions, restore"
              + " it from a backup, or move it away to begin with no registrations.",
          e);
    }
  }

  private static Journal open(Path folder, ProcessLock lock, int snapshotThreshold)
      throws IOException {
    boolean torn = JournalScan.check(folder);
    JournalHandler handler = new JournalHandler();
    ReliableLog log = new ReliableLog(folder.toString(), handler);
    log.recover();
    if (torn) {
      LOG.warn(
          "The last record of the journal in {} was torn; it was never acknowledged and is"
              + " dropped.",
          folder);
    }
    log.snapshot();
    return new Journal(folder, lock, snapshotThreshold, handler, log);
  }

  /**
   * Makes a change: first on disk, then in memory.
   *
   * @throws ActivationException if it could not be written, or its group is not registered any
   *     more; then the change did not take effect
   */
  synchronized void commit(JournalRecord change) throws ActivationException {
    registrations.check(change);
    try {
      ReliableLog open = openedLog();
      log = null; // not to be used again if it fails half-way
      write(open, change);
      log = open;
    } catch (IOException e) {
      throw new ActivationException(
          "phoenix could not record the change in "
              + folder
              + " ("
              + innermost(e)
              + "), so it has not happened; free space there and try again",
          e);
    }
    registrations.apply(change);
    if (++pending >= snapshotThreshold) {
      snapshot();
    }
  }

  /** Runs a query on the registrations. */
  synchronized <T extends @Nullable Object> T read(Function<Registrations, T> query) {
    return query.apply(registrations);
  }

  /**
   * A group's descriptor.
   *
   * @throws UnknownGroupException if the group is not registered, or not any more
   */
  synchronized ActivationGroupDesc groupDesc(ActivationGroupID id) throws UnknownGroupException {
    Registrations.@Nullable GroupRecord group = registrations.groups.get(id);
    if (group == null) {
      throw new UnknownGroupException("phoenix has no such group registered");
    }
    return group.desc;
  }

  private static void write(ReliableLog open, JournalRecord change) throws IOException {
    try {
      open.update(change);
    } catch (IOException e) {
      open.close();
      throw e;
    }
  }

  private ReliableLog openedLog() throws IOException {
    if (closed) {
      throw new IOException("the journal is closed");
    }
    if (log != null) {
      return log;
    }
    ReliableLog again = new ReliableLog(folder.toString(), new JournalHandler(registrations));
    again.snapshot();
    pending = 0;
    LOG.info("The journal in {} can be written again.", folder);
    return again;
  }

  private void snapshot() {
    ReliableLog open = log;
    if (open == null) {
      return;
    }
    try {
      log = null;
      open.snapshot();
      log = open;
      pending = 0;
    } catch (IOException e) {
      LOG.error(
          "No snapshot can be written to {} ({}). What is registered stays safe in the journal as"
              + " it is; no further change is accepted until there is space.",
          folder,
          innermost(e));
    }
  }

  @Override
  public synchronized void close() throws IOException {
    closed = true;
    try (lock) {
      if (log != null) {
        log.close();
        log = null;
      }
    }
  }

  private static String innermost(Throwable e) {
    Throwable at = e;
    while (at.getCause() != null && at.getCause() != at) {
      at = at.getCause();
    }
    return at.getMessage() == null ? at.getClass().getSimpleName() : at.getMessage();
  }
}
