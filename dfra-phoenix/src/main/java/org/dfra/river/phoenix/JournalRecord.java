package org.dfra.river.phoenix;

import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.server.UID;

/** One record of the journal: a change of the registrations. */
sealed interface JournalRecord extends Serializable {

  /** A group was registered under a name that the daemon chose. */
  record GroupRegistered(ActivationGroupID group, String name, ActivationGroupDesc desc)
      implements JournalRecord {}

  /** A group's descriptor was replaced. */
  record GroupDescribed(ActivationGroupID group, ActivationGroupDesc desc)
      implements JournalRecord {}

  /** A group and its objects received a new identity: phoenix restarted at another address. */
  record GroupMoved(ActivationGroupID group, ActivationGroupID to) implements JournalRecord {}

  /** A group and its objects were unregistered. */
  record GroupUnregistered(ActivationGroupID group) implements JournalRecord {}

  /** A process will be started for the group. Written before the start. */
  record Launching(ActivationGroupID group, long incarnation) implements JournalRecord {}

  /** The process was started. Written before the process receives its group. */
  record Launched(ActivationGroupID group, ProcessIdentity process) implements JournalRecord {}

  /** The process reported its instantiator. Written before the answer to its report. */
  record Reported(ActivationGroupID group, MarshalledObject<ActivationInstantiator> instantiator)
      implements JournalRecord {}

  /** The group reported that it instantiates no more objects. */
  record Left(ActivationGroupID group) implements JournalRecord {}

  /** An object was registered. */
  record ObjectRegistered(UID object, ActivationDesc desc) implements JournalRecord {}

  /** An object's descriptor was replaced, in the same group. */
  record ObjectDescribed(UID object, ActivationDesc desc) implements JournalRecord {}

  /**
   * An object was unregistered.
   *
   * @param incarnation of its group's process, if that may still have the object; else 0
   */
  record ObjectUnregistered(UID object, long incarnation) implements JournalRecord {}

  /** An unregistered object became inactive in the process that still had it. */
  record UnregisteredEnded(ActivationGroupID group, UID object) implements JournalRecord {}
}
