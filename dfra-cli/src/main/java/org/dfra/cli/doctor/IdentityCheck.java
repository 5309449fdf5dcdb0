package org.dfra.cli.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.SecureProcess.Installed;

/** Reports who this computer is, and whether others believe it. */
final class IdentityCheck implements Check {

  private final Installed own;
  private final Optional<String> clockFault;

  /**
   * @param clockFault why this computer's clock does not count, in a sentence; empty if it does
   */
  IdentityCheck(Installed own, Optional<String> clockFault) {
    this.own = own;
    this.clockFault = clockFault;
  }

  /** The check for what this command was started with. */
  static IdentityCheck ofThisProcess() {
    return new IdentityCheck(SecureProcess.current(), SecureProcess.clockFault());
  }

  @Override
  public Subject subject() {
    return Subject.IDENTITY;
  }

  @Override
  public List<Finding> run() {
    List<Finding> findings = new ArrayList<>();
    findings.add(identity());
    clockFault.ifPresent(
        fault ->
            findings.add(
                Finding.warn(
                    subject(), fault, "Set this computer's clock, by hand or by chrony.")));
    return findings;
  }

  private Finding identity() {
    return switch (own.mode()) {
      case SECURE ->
          Finding.ok(
              subject(),
              "this computer is " + own.name() + ": its calls are encrypted and authenticated");
      case CLOSED ->
          Finding.fail(
              subject(),
              own.name() + " works for itself only: " + own.fault(),
              "Join the team again with a new bundle: "
                  + CommandName.current()
                  + " security join NAME.bundle.");
      case OPEN ->
          Finding.ok(
              subject(),
              "this computer has joined no team: calls are neither encrypted nor authenticated,"
                  + " and its robots are open to every program that reaches them");
    };
  }
}
