package org.dfra.app.module;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.module.Readiness;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.river.lookup.UnreadableModule;

/**
 * A module as its entries tell of it, without asking it.
 *
 * @param robot name of its robot
 * @param name its name
 * @param kinds what it is, such as {@code GPSSensor}
 * @param state how far it has come; absent where its entries do not tell
 * @param stopped whether it is an effector that is stopped for an emergency
 * @param clients how many clients hold a lease on it
 * @param host address of the computer it runs on
 * @param locality how near it is
 * @param stale whether no registrar that answers holds it any more
 * @param confirmed when a registrar last did
 * @param id its service ID
 * @param reason why it does not serve, or why its classes are refused here; absent where it serves
 * @param refused whether its proxy cannot be read here
 * @param held why its robot answers no call for help, where it is a recruitment agent; absent where
 *     it is not held
 */
public record ModuleView(
    String robot,
    String name,
    List<String> kinds,
    Optional<Readiness> state,
    boolean stopped,
    int clients,
    String host,
    Locality locality,
    boolean stale,
    Instant confirmed,
    String id,
    Optional<String> reason,
    boolean refused,
    Optional<String> held) {

  public ModuleView {
    kinds = List.copyOf(kinds);
  }

  /** What a listing tells. */
  public static ModuleView of(ModuleListing<? extends Module> listing) {
    Optional<ModuleAttributes> attributes = listing.attributes(ModuleAttributes.class);
    return new ModuleView(
        listing.robot(),
        listing.name(),
        ModuleKinds.names(listing.module()),
        attributes.map(ModuleAttributes::state),
        listing
            .attributes(EmergencyStopAttributes.class)
            .filter(EmergencyStopAttributes::latched)
            .isPresent(),
        attributes.map(ModuleAttributes::clients).orElse(0),
        attributes.map(ModuleAttributes::host).orElse(""),
        listing.locality(),
        listing.stale(),
        listing.confirmed(),
        listing.id().toString(),
        Optional.empty(),
        false,
        listing.attributes(RecruitmentAttributes.class).map(RecruitmentAttributes::holdReason));
  }

  /** What is known of one whose proxy cannot be read here. */
  static ModuleView of(UnreadableModule module) {
    return new ModuleView(
        module.robot(),
        module.name(),
        List.of(),
        Optional.empty(),
        false,
        0,
        module.host(),
        Locality.REMOTE,
        false,
        Instant.now(),
        module.id(),
        Optional.of(module.reason()),
        true,
        Optional.empty());
  }

  /** The same with the reason why it does not serve. */
  ModuleView withReason(String why) {
    return new ModuleView(
        robot,
        name,
        kinds,
        state,
        stopped,
        clients,
        host,
        locality,
        stale,
        confirmed,
        id,
        Optional.of(why),
        refused,
        held);
  }

  /** A sentence about one that cannot be used now; empty where it can be. */
  Optional<String> unusableReason() {
    return reason.map(
        why ->
            path()
                + (refused
                    ? " cannot be used here: "
                    : " is " + ModuleListPrinter.state(this) + ": ")
                + why
                + (why.endsWith("?") ? "" : "."));
  }

  /** A sentence about a robot that is held; empty where this does not tell of one. */
  Optional<String> hold() {
    return held.map(
        why ->
            robot
                + " is held and answers no call for help: "
                + why
                + ". When it may move: ./dfra recruit resume "
                + robot);
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
