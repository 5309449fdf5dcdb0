package org.dfra.examples.recruit;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dfra.agent.HelpCall;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage.Help;
import org.dfra.recruit.message.SentMessage;
import org.jspecify.annotations.Nullable;

/** Messages sorted into conversations with readable names: a call, and an attempt at it. */
final class Conversations {

  /**
   * One conversation.
   *
   * @param call counts the calls of all robots from 1
   * @param attempt counts the conversations of that call from 1: the next one replaces a late
   *     helper
   * @param begun when its first message was sent, by its sender's clock
   * @param messages in the order sent, at least one
   */
  record Attempt(
      String requester,
      int call,
      int attempt,
      HelpCall asked,
      Instant begun,
      List<SentMessage> messages) {

    /** Such as {@code call-2-attempt-1}. */
    String file() {
      return "call-" + call + "-attempt-" + attempt;
    }
  }

  private Conversations() {}

  /** All conversations in the order of their start; a new call has another place or purpose. */
  static List<Attempt> of(List<SentMessage> envelopes) {
    Map<Conversation, List<SentMessage>> sorted = new LinkedHashMap<>();
    envelopes.stream()
        .sorted(Comparator.comparing(SentMessage::measured))
        .forEach(
            each ->
                sorted
                    .computeIfAbsent(
                        each.envelope().message().conversation(), key -> new ArrayList<>())
                    .add(each));
    List<Attempt> all = new ArrayList<>();
    sorted.forEach(
        (conversation, reported) -> {
          HelpCall asked = asked(reported);
          if (asked != null) {
            all.add(next(all, conversation.requester(), asked, reported));
          }
        });
    return all;
  }

  private static @Nullable HelpCall asked(List<SentMessage> reported) {
    return reported.stream()
        .map(each -> each.envelope().message() instanceof Help help ? help.call() : null)
        .filter(call -> call != null)
        .findFirst()
        .orElse(null);
  }

  private static Attempt next(
      List<Attempt> before, String requester, HelpCall asked, List<SentMessage> envelopes) {
    List<Attempt> same =
        before.stream()
            .filter(each -> each.requester().equals(requester) && each.asked().equals(asked))
            .toList();
    int call =
        same.isEmpty()
            ? 1 + before.stream().mapToInt(Attempt::call).max().orElse(0)
            : same.get(0).call();
    int attempt = 1 + same.size();
    return new Attempt(
        requester, call, attempt, asked, envelopes.get(0).measured(), List.copyOf(envelopes));
  }
}
