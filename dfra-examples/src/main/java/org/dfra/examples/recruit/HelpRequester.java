package org.dfra.examples.recruit;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.agent.HelpCall;
import org.dfra.agent.HelpCallRejectedException;
import org.dfra.agent.HelpCallRejectedException.Reason;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.directory.CallFailedException;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;

/** The help requests of one robot to its agent, and their results. */
final class HelpRequester {

  /** Timeout of all waits, real time. */
  static final Duration PATIENCE = Duration.ofSeconds(120);

  private final ProgressReporter progress;
  private final String requester;
  private final RecruitmentAgent agent;
  private final AgentMonitor monitor;
  private final LocalFrame frame;

  /**
   * @param agent of the requester
   * @param frame the world's
   */
  HelpRequester(
      ProgressReporter progress,
      String requester,
      RecruitmentAgent agent,
      AgentMonitor monitor,
      LocalFrame frame) {
    this.progress = progress;
    this.requester = requester;
    this.agent = agent;
    this.monitor = monitor;
    this.frame = frame;
  }

  /**
   * Waits until the agent has found the others: until then it answers that it is alone. A busy
   * computer may answer late; the call is refused, so it may be repeated.
   */
  void awaitOthers(HelpCall impossible) throws Exception {
    progress.step("waiting until " + requester + " sees the others");
    DemoAssertions.await(
        "that " + requester + " sees the others",
        PATIENCE,
        () -> {
          try {
            return refusal(impossible).filter(each -> each.reason() != Reason.ALONE).isPresent();
          } catch (CallFailedException e) {
            return false;
          }
        });
  }

  /** Makes an impossible call and checks that it is refused. */
  void requireRefused(HelpCall call) throws IOException {
    LocalPosition at = frame.toLocal(call.position());
    Optional<HelpCallRejectedException> refusal = refusal(call);
    DemoAssertions.require(
        refusal.isPresent(), requester + " made an impossible call that was accepted: " + call);
    progress.say(
        "%s calls for a robot that can observe \"%s\", %.0f m east and %.0f m north; its agent"
            + " answers: %s.",
        requester,
        call.percept(),
        at.east(),
        at.north(),
        String.valueOf(refusal.orElseThrow().getMessage()));
  }

  private Optional<HelpCallRejectedException> refusal(HelpCall call) throws RemoteException {
    try {
      agent.callForHelp(call);
      agent.release();
      return Optional.empty();
    } catch (HelpCallRejectedException e) {
      return Optional.of(e);
    }
  }

  /** Calls, and waits until a helper is travelling that is not one of those. */
  String call(HelpCall call, Set<String> others) throws Exception {
    progress.step("calling for help");
    AtomicReference<String> refused = new AtomicReference<>("it has not answered");
    AtomicBoolean mayHaveBegun = new AtomicBoolean();
    boolean calls =
        DemoAssertions.holdsWithin(
            PATIENCE,
            () -> {
              try {
                agent.callForHelp(call);
                return true;
              } catch (HelpCallRejectedException e) {
                refused.set(String.valueOf(e.getMessage()));
                // it has not discovered the others yet, or its last call is not over, or this is it
                return mayHaveBegun.get() && isCalling();
              } catch (CallFailedException e) { // a late answer
                mayHaveBegun.set(true);
                return isCalling();
              }
            });
    DemoAssertions.require(calls, requester + " cannot call for help: " + refused.get());
    LocalPosition at = frame.toLocal(call.position());
    progress.say(
        "%s calls for a robot that can observe \"%s\", %.0f m east and %.0f m north.",
        requester, call.percept(), at.east(), at.north());
    return awaitTravelling(others);
  }

  private boolean isCalling() throws RemoteException {
    try {
      return agent.status().requesterPhase() != RequesterPhase.IDLE;
    } catch (CallFailedException e) {
      return false; // asked again
    }
  }

  /** Waits until a helper is travelling that is not one of those. */
  String awaitTravelling(Set<String> others) throws Exception {
    progress.step("waiting for a helper");
    DemoAssertions.await(
        "that a helper is on its way", PATIENCE, () -> monitor.committed(others).isPresent());
    return monitor.committed(others).orElseThrow();
  }

  /** Waits until a robot helps; it may differ from the one that travelled first. */
  String awaitArrival() throws Exception {
    await(RequesterPhase.BEING_HELPED);
    String helper = monitor.last(requester).orElseThrow().helperRobot();
    DemoAssertions.require(helper != null, requester + " has no helper");
    await(String.valueOf(helper), ResponderPhase.LEASED);
    return String.valueOf(helper);
  }

  /** Releases the helper. */
  void release(String helper) throws Exception {
    progress.say("%s has seen enough and releases %s.", requester, helper);
    agent.release();
    await(helper, ResponderPhase.FREE);
    await(RequesterPhase.IDLE);
  }

  /** Waits until another robot's agent reports that phase. */
  void await(String robot, ResponderPhase phase) throws Exception {
    progress.step("waiting until " + robot + " is " + phase);
    DemoAssertions.await(
        "that " + robot + " is " + phase,
        PATIENCE,
        () -> monitor.last(robot).filter(each -> each.responderPhase() == phase).isPresent());
  }

  /** Waits until the requester's agent reports that phase. */
  void await(RequesterPhase phase) throws Exception {
    progress.step("waiting until " + requester + " is " + phase);
    DemoAssertions.await(
        "that " + requester + " is " + phase,
        PATIENCE,
        () -> monitor.last(requester).filter(each -> each.requesterPhase() == phase).isPresent());
  }
}
