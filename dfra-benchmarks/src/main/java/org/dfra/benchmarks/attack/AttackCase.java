package org.dfra.benchmarks.attack;

import java.util.List;

/**
 * An attack and its requirements.
 *
 * @param name its name
 * @param task the task of the attacker's process
 * @param attacker the kind of attacker
 * @param target the part of the robot that it attacks
 */
public record AttackCase(
    String name, Class<? extends AttackTask> task, Attacker attacker, Target target) {

  /** Kinds of attackers. */
  public enum Attacker {
    /** A program on another computer. */
    STRANGER,
    /** A program of another user of the robot's computer. */
    LOCAL_USER,
    /** The same, or {@link #STRANGER} if this process cannot start programs of other users. */
    LOCAL_USER_OR_STRANGER
  }

  /** What an attack is directed at. */
  public enum Target {
    /** The robot's modules and lookup service, at their addresses. */
    SERVICES,
    /** The discovery of robots that discover by multicast. */
    MULTICAST_DISCOVERY,
    /** The robot's phoenix. */
    PHOENIX
  }

  /** The neutral load with which the attacks are compared. */
  public static final AttackCase BASELINE = stranger("a neutral load", NeutralLoad.class);

  /** All attacks; {@code docs/concepts/security.md} numbers them. */
  public static final List<AttackCase> ALL =
      List.of(
          stranger("fake modules", FakeModules.class), // 1, 2
          stranger("administrative calls", AdministrativeCalls.class), // 3
          onPhoenix("registered groups", GroupRegistrations.class, Attacker.LOCAL_USER_OR_STRANGER),
          stranger("changes of the registrar", RegistrarChanges.class), // 5
          stranger("JRMP references", JrmpReferences.class), // 6
          stranger("hash bombs", HashBombs.class), // 7
          byMulticast("discovery bombs", DiscoveryBombs.class), // 8
          stranger("unfinished requests", UnfinishedRequests.class), // 9, 10
          stranger("a flood of listeners", ListenerFlood.class), // 10
          onPhoenix("stolen locks", LockTheft.class, Attacker.LOCAL_USER), // 11
          stranger("forged text", ForgedText.class), // 12
          stranger("slow headers", SlowHeaders.class), // 13
          stranger("nested XML", NestedXml.class), // 14
          byMulticast("rogue announcements", RogueAnnouncements.class)); // 14

  private static AttackCase stranger(String name, Class<? extends AttackTask> task) {
    return new AttackCase(name, task, Attacker.STRANGER, Target.SERVICES);
  }

  private static AttackCase byMulticast(String name, Class<? extends AttackTask> task) {
    return new AttackCase(name, task, Attacker.STRANGER, Target.MULTICAST_DISCOVERY);
  }

  private static AttackCase onPhoenix(
      String name, Class<? extends AttackTask> task, Attacker attacker) {
    return new AttackCase(name, task, attacker, Target.PHOENIX);
  }

  /** Whether it reaches only robots that discover by multicast. */
  public boolean isByMulticast() {
    return target == Target.MULTICAST_DISCOVERY;
  }

  /** Whether it attacks the robot's phoenix. */
  public boolean isOnPhoenix() {
    return target == Target.PHOENIX;
  }
}
