package org.dfra.cli.doctor;

import java.rmi.AccessException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.dfra.river.bootstrap.NoAnswerException;
import org.dfra.river.phoenix.GroupStatus;

/** Checks whether this host's phoenix answers, and the state of its groups. */
final class PhoenixCheck implements Check {

  /** The phoenix of this host. */
  interface Daemon {
    /** Its address, {@code host:port}. */
    String address();

    /** The process that owns the journal, if there is one. */
    OptionalLong pid();

    /**
     * The status of its groups.
     *
     * @throws AccessException if it belongs to another user
     */
    List<GroupStatus> groups() throws RemoteException;

    /** Its log file. */
    String log();
  }

  private final Daemon phoenix;

  PhoenixCheck(Daemon phoenix) {
    this.phoenix = phoenix;
  }

  @Override
  public Subject subject() {
    return Subject.PHOENIX;
  }

  @Override
  public List<Finding> run() {
    List<GroupStatus> groups;
    try {
      groups = phoenix.groups();
    } catch (AccessException e) {
      return List.of(
          Finding.warn(
              subject(),
              String.valueOf(e.getMessage()),
              "Ask as that user; for a phoenix of your own name a free --port and a --state"
                  + " folder."));
    } catch (RemoteException e) {
      return List.of(silent(e));
    }
    List<Finding> findings = new ArrayList<>();
    OptionalLong pid = phoenix.pid();
    findings.add(
        Finding.ok(
            subject(),
            (pid.isPresent() ? "process " + pid.getAsLong() : "another user's process")
                + " answers at "
                + phoenix.address()));
    groups.forEach(each -> findings.add(group(each)));
    return findings;
  }

  private Finding silent(RemoteException failure) {
    OptionalLong pid = phoenix.pid();
    if (pid.isEmpty() && failure instanceof NoAnswerException) {
      return Finding.fail(
          subject(),
          "it is not known whether one runs at "
              + phoenix.address()
              + ", since it does not answer ("
              + reason(failure)
              + ")",
          "See whether another program has that port, and whether the computer is overloaded.");
    }
    if (pid.isEmpty()) {
      return Finding.warn(
          subject(),
          "none answers at "
              + phoenix.address()
              + ", so nothing is brought up or back on this host",
          "Bring one up: "
              + CommandName.current()
              + " up ROBOT.XML; for a robot elsewhere nothing is to be done.");
    }
    return Finding.fail(
        subject(),
        "process "
            + pid.getAsLong()
            + " does not answer at "
            + phoenix.address()
            + " ("
            + reason(failure)
            + ")",
        "See "
            + phoenix.log()
            + "; if it is stopped or hangs, kill -9 "
            + pid.getAsLong()
            + " and bring the robots up again: their groups continue meanwhile.");
  }

  private static String reason(RemoteException failure) {
    Throwable last =
        failure instanceof NoAnswerException && failure.getCause() != null
            ? failure.getCause()
            : failure;
    String text = String.valueOf(last.getMessage());
    int nested = text.indexOf(';');
    return nested < 0 ? text : text.substring(0, nested);
  }

  private static Finding group(GroupStatus group) {
    String name = "group " + group.name().replaceFirst("^\\d+-", "");
    if (group.heldOffUntil() != null) {
      return Finding.fail(
          Subject.GROUP,
          name
              + " crashed too often and is held off until "
              + group.heldOffUntil()
              + " ("
              + (group.lastCrash() == null ? "the cause is not known" : group.lastCrash())
              + ")",
          "See why in " + group.output() + " and in the .vm.log beside it, and remove the cause.");
    }
    if (group.unregistered() > 0) {
      return Finding.warn(
          Subject.GROUP,
          name
              + " is process "
              + group.pid()
              + " and still has "
              + group.unregistered()
              + (group.unregistered() == 1 ? " service" : " services")
              + " that phoenix has forgotten, as an interrupted "
              + CommandName.current()
              + " down leaves it",
          "End the process: "
              + CommandName.current()
              + " down "
              + name.replaceFirst("^group ", "").replaceFirst("\\..*", "")
              + ", or "
              + CommandName.current()
              + " up with the robot's XML.");
    }
    if (group.recentCrashes() > 0) {
      return Finding.warn(
          Subject.GROUP,
          name + " crashed lately: " + group.lastCrash(),
          "See why in " + group.output() + " and in the .vm.log beside it.");
    }
    return Finding.ok(
        Subject.GROUP,
        group.pid() < 0 ? name + " waits for a call" : name + " is process " + group.pid());
  }
}
