dependencies {
    api(project(":dfra-core"))
    api(project(":dfra-river"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
}

// dfra-recruit-dl.jar: what a client without dfra-recruit downloads. pom.xml has the same list.
val dlJar = tasks.register<Jar>("dlJar") {
    archiveClassifier.set("dl")
    from(sourceSets.main.get().output)
    include(
        "org/dfra/recruit/message/**",
        "org/dfra/recruit/river/AgentMessageEvent.class",
        "org/dfra/recruit/river/RemoteRecruitmentAgent.class",
        "org/dfra/recruit/river/RecruitmentAgentProxy.class",
        "org/dfra/recruit/river/RecruitmentEntry.class",
    )
}
tasks.assemble { dependsOn(dlJar) }
