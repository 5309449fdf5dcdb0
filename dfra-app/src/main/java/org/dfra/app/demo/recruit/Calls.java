package org.dfra.app.demo.recruit;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpRefusedException;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.app.demo.stage.Checks;
import org.dfra.app.demo.stage.Narration;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;

/** What one robot asks of its agent, and what comes of it. */
final class Calls {

  /** How long anything is awaited, real time. */
  static final Duration PATIENCE = Duration.ofSeconds(120);

  private final Narration tell;
  private final String requester;
  private final RecruitmentAgent agent;
  private final Witness witness;
  private final LocalFrame frame;

  /**
   * @param agent of the requester
   * @param frame the world's
   */
  Calls(
      Narration tell, String requester, RecruitmentAgent agent, Witness witness, LocalFrame frame) {
    this.tell = tell;
    this.requester = requester;
    this.agent = agent;
    this.witness = witness;
    this.frame = frame;
  }

  /** Waits until the agent has found the others: until then it answers that nobody is there. */
  void awaitOthers(HelpCall impossible) throws Exception {
    tell.step("waiting until " + requester + " sees the others");
    Checks.await(
        "that " + requester + " sees the others",
        PATIENCE,
        () -> refusal(impossible).filter(why -> !why.endsWith("nobody is there")).isPresent());
  }

  /** Calls for what cannot be had. */
  void refused(HelpCall call) throws IOException {
    LocalPosition at = frame.toLocal(call.place());
    Optional<String> why = refusal(call);
    Checks.require(why.isPresent(), requester + " calls for what cannot be had: " + call);
    tell.say(
        "%s wants somebody who can observe \"%s\", %.0f m east and %.0f m north; its agent"
            + " answers: %s.",
        requester, call.percept(), at.east(), at.north(), why.orElseThrow());
  }

  private Optional<String> refusal(HelpCall call) throws RemoteException {
    try {
      agent.help(call);
      agent.release();
      return Optional.empty();
    } catch (HelpRefusedException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  /** Calls, and waits until somebody is on its way who is not one of those. */
  String call(HelpCall call, Set<String> others) throws Exception {
    tell.step("calling for help");
    AtomicReference<String> refused = new AtomicReference<>("it has not answered");
    boolean calls =
        Checks.becomes(
            PATIENCE,
            () -> {
              try {
                agent.help(call);
                return true;
              } catch (HelpRefusedException e) {
                refused.set(String.valueOf(e.getMessage()));
                return false; // it has not seen the others yet, or its last call is not over
              }
            });
    Checks.require(calls, requester + " cannot call for help: " + refused.get());
    LocalPosition at = frame.toLocal(call.place());
    tell.say(
        "%s calls for somebody who can observe \"%s\", %.0f m east and %.0f m north.",
        requester, call.percept(), at.east(), at.north());
    return travelling(others);
  }

  /** Waits until somebody is on its way who is not one of those. */
  String travelling(Set<String> others) throws Exception {
    tell.step("waiting for a helper");
    Checks.await("that somebody comes", PATIENCE, () -> witness.committed(others).isPresent());
    return witness.committed(others).orElseThrow();
  }

  /** Waits until somebody helps, who need not be the one that was on its way first. */
  String arrived() throws Exception {
    await(RequesterPhase.DONE);
    String helper = witness.last(requester).orElseThrow().helper();
    Checks.require(helper != null, requester + " is helped by nobody");
    await(String.valueOf(helper), ResponderPhase.LEASED);
    return String.valueOf(helper);
  }

  /** Lets the helper go. */
  void release(String helper) throws Exception {
    tell.say("%s has seen enough and releases %s.", requester, helper);
    agent.release();
    await(helper, ResponderPhase.FREE);
    await(RequesterPhase.IDLE);
  }

  /** Waits until another robot's agent tells that. */
  void await(String robot, ResponderPhase phase) throws Exception {
    tell.step("waiting until " + robot + " is " + phase);
    Checks.await(
        "that " + robot + " is " + phase,
        PATIENCE,
        () -> witness.last(robot).filter(each -> each.responder() == phase).isPresent());
  }

  /** Waits until the requester's agent tells that. */
  void await(RequesterPhase phase) throws Exception {
    tell.step("waiting until " + requester + " is " + phase);
    Checks.await(
        "that " + requester + " is " + phase,
        PATIENCE,
        () -> witness.last(requester).filter(each -> each.requester() == phase).isPresent());
  }
}
