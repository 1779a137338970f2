@echo off
rem Entry to everything on Windows: builds the program when needed, then runs it. "range help" explains the commands.
setlocal
set DOTNET_CLI_TELEMETRY_OPTOUT=1
set DOTNET_NOLOGO=1
where dotnet >nul 2>nul
if errorlevel 1 (
  echo range: the .NET 10 SDK is not installed; get it from https://dotnet.microsoft.com/download/dotnet/10.0 1>&2
  exit /b 2
)
if not exist "%~dp0.artifacts" mkdir "%~dp0.artifacts"
dotnet build "%~dp0Packages\com.range.lasertracking\DotNet~\Host\Host.csproj" -c Release -v q --nologo > "%~dp0.artifacts\build.log" 2>&1
if errorlevel 1 (
  echo range: the build failed; the whole output is in .artifacts\build.log 1>&2
  exit /b 2
)
dotnet "%~dp0.artifacts\bin\Host\release\range.dll" %*
