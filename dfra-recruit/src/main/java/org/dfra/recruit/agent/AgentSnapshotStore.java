package org.dfra.recruit.agent;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import org.dfra.core.config.RecordedNames;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.core.time.ScaledTime;
import org.dfra.time.Scheduler;

/**
 * Stores the state of an agent that survives a restart of its process.
 *
 * <p>It is written and flushed to disk while the event that changed it is processed, before any
 * resulting message is sent: so a sender never loses the state that a message announced. A slow
 * disk thus delays the agent's next event, and others' messages to it, by the duration of a write,
 * milliseconds; a state changes about ten times per call. With asynchronous writes, the messages of
 * several events would have to wait for their writes in order, and pending ones would be lost when
 * the module ends. {@link Recruiter#status} does not wait.
 *
 * <p>The times of a snapshot use the agent's {@link #clock}, which is monotonic. The boot ID and
 * the time since boot are stored with it, so the clock continues in the next process, independently
 * of the computer's clock. A snapshot of another boot, or of another simulated time, is loaded
 * {@linkplain AgentSnapshot#afterAnotherBoot without its time spans}; likewise where the operating
 * system has no boot ID.
 */
final class AgentSnapshotStore {

  private static final String DOCUMENT = "recruitment";

  /** The only classes permitted in a snapshot: the file may have been tampered with. */
  private static final ObjectInputFilter SNAPSHOTS =
      ObjectInputFilter.Config.createFilter(
          "org.dfra.agent.*;org.dfra.geometry.*;org.dfra.recruit.**;java.lang.*;java.time.*;"
              + "java.util.*;maxdepth=20;maxarray=100000;!*");

  /**
   * The stored record.
   *
   * @param origin identifies the boot and the time base of both others; empty where unknown
   * @param sinceBoot nanoseconds of the robot's time
   * @param time by the agent's clock, at that moment
   */
  private record StoredSnapshot(String origin, long sinceBoot, Instant time, AgentSnapshot snapshot)
      implements Serializable {}

  /** The stored state exists but cannot be read. */
  static final class DamagedException extends IOException {

    private static final long serialVersionUID = 1;

    private DamagedException(String message, Exception cause) {
      super(message, cause);
    }
  }

  private final ModuleContext context;
  private final StateStore state;
  private final BootId boot;
  private SteadyClock clock; // replaced only by load, before its first use

  AgentSnapshotStore(ModuleContext context, BootId boot) {
    this.context = context;
    this.state = context.state();
    this.boot = boot;
    this.clock = new SteadyClock(context.clock().instant(), context.robotTime());
  }

  /**
   * The clock of all the agent's timeouts: after {@link #load}, continued from its last process.
   */
  InstantSource clock() {
    return clock;
  }

  /** The time base of {@link #sinceBoot}; empty where it cannot be identified again. */
  private String origin() throws IOException {
    String scaled = context.clock() instanceof ScaledTime time ? ", " + time : "";
    return boot.read().map(id -> id + scaled).orElse("");
  }

  /**
   * The robot's time in nanoseconds, from an origin that is the same in each process of this boot.
   * A scaled time's own origin is not, where the computer's clock was set between two of them.
   */
  private long sinceBoot() {
    return context.clock() instanceof ScaledTime time
        ? (long) (context.scheduler().nanos() * time.speed())
        : context.robotTime().nanos();
  }

  /**
   * @throws IOException if it cannot be written; the previous state stays stored
   */
  void save(AgentSnapshot snapshot) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new StoredSnapshot(origin(), sinceBoot(), clock.instant(), snapshot));
    }
    state.write(DOCUMENT, bytes.toByteArray());
  }

  /**
   * Loads the stored state. The agent's clock continues from there.
   *
   * @throws IOException if it cannot be read, is invalid, or the current boot is unknown; then
   *     {@link #loadWithoutTimers} may load a part
   */
  Optional<AgentSnapshot> load() throws IOException {
    Optional<StoredSnapshot> kept = read();
    return kept.isEmpty() ? Optional.empty() : Optional.of(goOn(kept.get()));
  }

  /**
   * Loads the part of the stored state that must not be repeated, as {@linkplain
   * AgentSnapshot#afterAnotherBoot after another boot}: where it is unknown whether the boot is the
   * same.
   *
   * @throws DamagedException if it is invalid; the message names the file
   * @throws IOException if it cannot be read; likewise
   */
  Optional<AgentSnapshot> loadWithoutTimers() throws IOException {
    return read().map(this::withoutSpans);
  }

  private Optional<StoredSnapshot> read() throws IOException {
    String what = "the stored state of its conversations, " + state + "/" + DOCUMENT;
    Optional<byte[]> kept;
    try {
      kept = state.read(DOCUMENT);
    } catch (IOException e) { // a disk error, or no file descriptors
      throw new IOException(what + ", cannot be read: " + e, e);
    }
    try {
      return kept.isEmpty() ? Optional.empty() : Optional.of(read(kept.get()));
    } catch (IOException | ClassNotFoundException | RuntimeException e) {
      throw new DamagedException(what + ", cannot be decoded: " + e, e);
    }
  }

  private StoredSnapshot read(byte[] kept) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(RecordedNames.translate(kept)))) {
      in.setObjectInputFilter(SNAPSHOTS);
      Object found = in.readObject();
      if (found instanceof StoredSnapshot last) {
        return last;
      }
      if (found instanceof AgentSnapshot snapshot) { // of an earlier version, by the wall clock
        return new StoredSnapshot("", 0, context.clock().instant(), snapshot);
      }
      throw new InvalidObjectException("it contains another type of object");
    }
  }

  private AgentSnapshot goOn(StoredSnapshot last) throws IOException {
    long passed = sinceBoot() - last.sinceBoot();
    boolean isSameTime = !last.origin().isEmpty() && last.origin().equals(origin()) && passed >= 0;
    if (!isSameTime) {
      return withoutSpans(last);
    }
    clock = new SteadyClock(last.time().plusNanos(passed), context.robotTime());
    return last.snapshot();
  }

  private AgentSnapshot withoutSpans(StoredSnapshot last) {
    Instant wall = context.clock().instant();
    Instant now = wall.isAfter(last.time()) ? wall : last.time(); // message numbers use it
    clock = new SteadyClock(now, context.robotTime());
    return last.snapshot().afterAnotherBoot();
  }

  /**
   * A clock that a monotonic timer advances from its start. Setting the computer's clock changes no
   * timeout: two robots that measure the same timeout must not diverge. {@link AgentSnapshotStore}
   * sets its start, so that it continues in the next process.
   */
  static final class SteadyClock implements InstantSource {

    private final Instant began;
    private final long beganNanos;
    private final Scheduler timer;

    /**
     * @param began its current time
     */
    SteadyClock(Instant began, Scheduler timer) {
      this.began = began;
      this.beganNanos = timer.nanos();
      this.timer = timer;
    }

    @Override
    public Instant instant() {
      return began.plusNanos(timer.nanos() - beganNanos);
    }
  }
}
