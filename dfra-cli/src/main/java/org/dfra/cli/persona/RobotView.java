package org.dfra.cli.persona;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.directory.Persona;
import org.dfra.persona.PersonaAttributes;

/**
 * A robot by its published attributes.
 *
 * @param robot its name
 * @param host address or name of its computer; empty if unknown
 * @param role its role in the team; absent if not set
 * @param goals its goals
 * @param limitations its limitations
 * @param modules number of its listed modules
 * @param stale whether no responding lookup service lists any of its modules
 * @param confirmed when one last did, if it is stale; else since when it has been known
 */
record RobotView(
    String robot,
    String host,
    Optional<String> role,
    List<String> goals,
    List<String> limitations,
    int modules,
    boolean stale,
    Instant confirmed) {

  RobotView {
    goals = List.copyOf(goals);
    limitations = List.copyOf(limitations);
  }

  static RobotView of(Persona persona) {
    Optional<PersonaAttributes> reported = persona.attributes();
    return new RobotView(
        persona.robot(),
        persona.host(),
        reported.map(PersonaAttributes::role).filter(role -> !role.isEmpty()),
        reported.map(PersonaAttributes::goals).orElse(List.of()),
        reported.map(PersonaAttributes::limitations).orElse(List.of()),
        persona.modules().size(),
        persona.stale(),
        persona.confirmed());
  }

  String roleInWords() {
    return role.orElse("-");
  }
}
