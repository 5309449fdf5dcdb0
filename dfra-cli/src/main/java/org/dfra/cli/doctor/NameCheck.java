package org.dfra.cli.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.cli.team.DuplicateRobotNames;

/** Checks whether the robots of the team have unique names. */
final class NameCheck implements Check {

  /** Finds robots that share a name. */
  interface NameProbe {
    /** The hosts for each name that more than one robot has. */
    Map<String, List<String>> hostsByDuplicateName() throws InterruptedException;
  }

  private final NameProbe names;

  NameCheck(NameProbe names) {
    this.names = names;
  }

  @Override
  public Subject subject() {
    return Subject.ROBOT_NAME;
  }

  @Override
  public List<Finding> run() throws InterruptedException {
    List<Finding> findings = new ArrayList<>();
    names
        .hostsByDuplicateName()
        .forEach(
            (robot, hosts) ->
                findings.add(
                    Finding.fail(
                        subject(),
                        DuplicateRobotNames.inWords(robot, hosts)
                            + ", so a call to "
                            + robot
                            + " may reach either",
                        "Take one of them down, give it another name in its XML and bring it up"
                            + " again; until then name a module as "
                            + robot
                            + (hosts.size() > Set.copyOf(hosts).size()
                                ? "@ID/MODULE, with the first eight digits of its service ID,"
                                    + " which module list --json shows."
                                : "@HOST/MODULE."))));
    return findings;
  }
}
