package org.dfra.app.persona;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.directory.Persona;
import org.dfra.persona.PersonaAttributes;

/**
 * A robot as it shows itself.
 *
 * @param robot its name
 * @param host address or name of the computer it runs on; empty where that is not known
 * @param role its role in the team; absent where it tells none
 * @param goals what it tries to achieve
 * @param limitations what it cannot do
 * @param modules how many modules it shows
 * @param stale whether no lookup service that answers vouches for anything of it
 * @param confirmed when one last did, where it is stale; else since when it has been known
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
