package org.dfra.river.bootstrap;

import java.io.IOException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.GroupStatus.State;
import org.dfra.river.phoenix.ProcessIdentity;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Ends service groups: their processes exit before phoenix unregisters them. */
final class GroupTerminator {

  private static final Logger LOG = LoggerFactory.getLogger(GroupTerminator.class);

  /** The process ID if there is no process. */
  private static final long NONE = -1;

  private final PhoenixClient phoenix;
  private final RetryDeadline patience;

  /**
   * @param patience limits the retries of calls to phoenix
   */
  GroupTerminator(PhoenixClient phoenix, RetryDeadline patience) {
    this.phoenix = phoenix;
    this.patience = patience;
  }

  /**
   * Unregisters an object from phoenix; does nothing if it is not registered. Its process is not
   * touched.
   */
  void unregister(ActivationID object) throws IOException, ActivationException {
    try {
      patience.run(() -> phoenix.system().unregisterObject(object));
    } catch (UnknownObjectException e) {
      LOG.debug("{} was unregistered before.", object, e);
    }
  }

  /** Unregisters a group from phoenix; does nothing if it is not registered. */
  void unregister(ActivationGroupID group) throws IOException, ActivationException {
    try {
      patience.run(() -> phoenix.system().unregisterGroup(group));
    } catch (UnknownGroupException e) {
      LOG.debug("{} was unregistered before.", group, e);
    }
  }

  /**
   * The status of a group as phoenix reports it; empty if phoenix has no group of that name.
   *
   * @param name {@code robot.group}
   */
  Optional<GroupStatus> status(String name) throws IOException, ActivationException {
    return statuses().stream().filter(each -> plain(each.name()).equals(name)).findFirst();
  }

  /** The status of all groups as phoenix reports it. */
  List<GroupStatus> statuses() throws IOException, ActivationException {
    return patience.call(phoenix.admin()::groupStatus);
  }

  /** A group's name as the bootstrap set it, without phoenix's number. */
  static String plain(String daemonsName) {
    return daemonsName.replaceFirst("^\\d+-", "");
  }

  /** Requests an orderly end of a group's process; does not wait for it. */
  void requestStop(String name) throws IOException, ActivationException {
    process(status(name)).ifPresent(process -> process.terminate());
  }

  /**
   * Ends the process of a group in which nothing is registered any more, and waits until phoenix
   * has recorded its exit.
   *
   * @param time the time limit, after which the process is killed
   */
  void terminate(String name, Duration time) throws IOException, ActivationException {
    RetryDeadline polite = RetryDeadline.of(time);
    @Nullable ProcessIdentity ended = null;
    while (true) {
      Optional<GroupStatus> status = status(name);
      if (status.isEmpty() || status.get().state() == State.IDLE) {
        return;
      }
      ended = terminate(name, process(status), ended, polite);
    }
  }

  /**
   * Ends a group's process and waits until it has exited; phoenix starts another one for the
   * services that are registered in the group.
   *
   * @param time the time limit, after which the process is killed
   */
  void restart(String name, Duration time) throws IOException, ActivationException {
    Optional<ProcessIdentity> old = process(status(name));
    RetryDeadline polite = RetryDeadline.of(time);
    @Nullable ProcessIdentity ended = null;
    while (old.isPresent() && old.get().isAlive() && process(status(name)).equals(old)) {
      ended = terminate(name, old, ended, polite);
    }
  }

  /** A group's process; empty if it has none, or if the process has just exited. */
  private static Optional<ProcessIdentity> process(Optional<GroupStatus> status)
      throws IOException {
    long pid = status.map(GroupStatus::pid).orElse(NONE);
    return pid < 0 ? Optional.empty() : ProcessIdentity.find(pid);
  }

  /**
   * Ends the process: the first time by SIGTERM, after the timeout by SIGKILL. Returns the process.
   */
  private static @Nullable ProcessIdentity terminate(
      String name,
      Optional<ProcessIdentity> process,
      @Nullable ProcessIdentity before,
      RetryDeadline polite) {
    if (process.isPresent() && !process.get().equals(before)) {
      process.get().terminate();
    } else if (process.isPresent() && polite.isExpired()) {
      LOG.warn("Process {} of group {} did not end; it is killed.", process.get().pid(), name);
      process.get().kill();
    }
    polite.pause();
    return process.orElse(before);
  }
}
