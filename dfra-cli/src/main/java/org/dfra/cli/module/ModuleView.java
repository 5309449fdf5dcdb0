package org.dfra.cli.module;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.core.host.CommandName;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;

/**
 * A module by its lookup entries, without a call to it.
 *
 * @param robot name of its robot
 * @param name its name
 * @param kinds its kinds, such as {@code GPSSensor}
 * @param state its readiness; absent if its entries have none
 * @param stopped whether it is an effector in emergency stop
 * @param clients number of clients that hold a lease on it
 * @param host address of its computer
 * @param locality its locality relative to this process
 * @param stale whether no responding registrar lists it any more
 * @param confirmed when a registrar last listed it
 * @param id its service ID
 * @param reason why it is not ready, or why its classes are refused here; absent if it is ready
 * @param refused whether its proxy cannot be deserialized here
 * @param held why its robot is suspended from recruitment, if it is a recruitment agent; absent if
 *     it is not suspended
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

  /** The view of a listing. */
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

  /** The known data of a module whose proxy cannot be deserialized here. */
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

  /** The same with the reason why it is not ready. */
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

  /** A sentence about why it cannot be used now; empty if it can. */
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

  /** A sentence about a robot that is suspended from recruitment; empty if it is not. */
  Optional<String> hold() {
    return held.map(
        why ->
            robot
                + " is held and answers no call for help: "
                + why
                + ". When it may move: "
                + CommandName.current()
                + " recruit resume "
                + robot);
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
